package org.urbi.lang.grammar;

/** {@code BIN size keywords;data} (manual, "Binary"). */
public record BinaryLiteral(String keywords, String data) {}

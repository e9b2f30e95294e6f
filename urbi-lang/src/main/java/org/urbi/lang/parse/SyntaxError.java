package org.urbi.lang.parse;

import org.urbi.lang.source.Span;

/** Why a text is no program; the message starts with {@code syntax error: }. */
public record SyntaxError(Span span, String message) {}

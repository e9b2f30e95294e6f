package org.urbi.lang.parse;

import org.urbi.lang.source.Span;

/** What a text that is understood should not say, for instance because it is deprecated. */
public record SyntaxWarning(Span span, String message) {}

package org.urbi.lang.parse;

import org.urbi.lang.source.Span;

/**
 * Something that is not urbiscript.
 *
 * @param message as the interpreter says it, {@code syntax error: …}
 */
public record SyntaxError(Span span, String message) {}

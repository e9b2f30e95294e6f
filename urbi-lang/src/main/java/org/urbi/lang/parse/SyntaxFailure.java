package org.urbi.lang.parse;

import org.urbi.lang.source.Span;

/** Leaves the construction of a tree at the first error. */
final class SyntaxFailure extends RuntimeException {
  private static final long serialVersionUID = 1;

  private final transient Span span;

  SyntaxFailure(Span span, String message) {
    super("syntax error: " + message, null, false, false);
    this.span = span;
  }

  SyntaxError error() {
    return new SyntaxError(span, getMessage());
  }
}

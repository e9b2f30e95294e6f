package org.urbi.lang.parse;

import org.urbi.lang.source.Span;

/** Leaves the construction of a tree at the first error. */
final class SyntaxFailure extends RuntimeException {
  private static final long serialVersionUID = 1;

  private final transient SyntaxError error;

  SyntaxFailure(Span span, String message) {
    this(new SyntaxError(span, "syntax error: " + message));
  }

  private SyntaxFailure(SyntaxError error) {
    super(error.message(), null, false, false);
    this.error = error;
  }

  SyntaxError error() {
    return error;
  }
}

package org.urbi.lang.parse;

import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Span;

/** Leaves the construction of a tree at the first error. */
final class SyntaxErrorException extends RuntimeException {
  private static final long serialVersionUID = 1;

  private final transient SyntaxError error;

  SyntaxErrorException(Span span, SyntaxProblem problem, Object... values) {
    this(SyntaxError.of(span, problem, values));
  }

  private SyntaxErrorException(SyntaxError error) {
    super(error.message(), null, false, false);
    this.error = error;
  }

  SyntaxError error() {
    return error;
  }
}

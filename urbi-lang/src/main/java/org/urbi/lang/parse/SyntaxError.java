package org.urbi.lang.parse;

import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Span;

/**
 * An error in a text.
 *
 * @param reason the text of the problem, filled in
 */
public record SyntaxError(Span span, SyntaxProblem problem, String reason) {
  /**
   * An error at a place.
   *
   * @param values what stands for the places of the message
   */
  public static SyntaxError of(Span span, SyntaxProblem problem, Object... values) {
    return new SyntaxError(span, problem, problem.text(values));
  }

  /** The message: {@code syntax error: reason}. */
  public String message() {
    return "syntax error: " + reason;
  }
}

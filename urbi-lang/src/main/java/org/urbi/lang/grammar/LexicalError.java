package org.urbi.lang.grammar;

import org.urbi.lang.problem.SyntaxProblem;

/**
 * An error or a warning of the scanner about a piece of text.
 *
 * @param begin offset of its first character
 * @param end offset after its last character
 * @param text the text of the problem, filled in
 */
public record LexicalError(int begin, int end, SyntaxProblem problem, String text) {
  /** Whether the text is understood nevertheless. */
  public boolean warning() {
    return problem.kind() == SyntaxProblem.Kind.WARNING;
  }
}

package org.urbi.lang.parse;

import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Span;

/**
 * A warning about a valid text, for instance that something is deprecated.
 *
 * @param message the text of the problem, filled in
 */
public record SyntaxWarning(Span span, SyntaxProblem problem, String message) {}

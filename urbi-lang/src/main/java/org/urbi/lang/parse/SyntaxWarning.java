package org.urbi.lang.parse;

import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.source.Span;

/**
 * What a text that is understood should not say, for instance because it is deprecated.
 *
 * @param message the text of the problem, filled in
 */
public record SyntaxWarning(Span span, SyntaxProblem problem, String message) {}

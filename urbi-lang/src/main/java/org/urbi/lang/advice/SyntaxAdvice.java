package org.urbi.lang.advice;

import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.parse.SyntaxError;
import org.urbi.lang.problem.SyntaxProblem;

/**
 * Guesses what was meant by a text with a syntax error, from the words around it. A wrong guess
 * costs nobody anything but the time to read it; so the rules are ordered from sure to vague.
 */
public final class SyntaxAdvice {
  private static final List<Function<Surroundings, @Nullable Advice>> RULES =
      List.of(
          BracketAdvice::unfinished,
          HabitAdvice::comment,
          HabitAdvice::type,
          HabitAdvice::declaration,
          HabitAdvice::value,
          HabitAdvice::statement,
          HabitAdvice::nested,
          HabitAdvice::name,
          WordAdvice::characters,
          OperatorAdvice::operator,
          BracketAdvice::condition,
          WordAdvice::keyword,
          BracketAdvice::closer,
          SeparatorAdvice::otherwise,
          BracketAdvice::parentheses,
          BracketAdvice::braces,
          StringAdvice::string,
          StringAdvice::apostrophe,
          SeparatorAdvice::missing,
          SeparatorAdvice::semicolon,
          OperatorAdvice::operand);

  private SyntaxAdvice() {}

  /** Whether a word declares what the next word names, or was meant to. */
  public static boolean isToDeclare(String word) {
    return WordAdvice.isToDeclare(word);
  }

  /** What there is to say about an error. */
  public static Advice of(SyntaxError error) {
    Advice own = Advice.of(error.problem().hint().orElse(null));
    if (error.problem() == SyntaxProblem.ARGUMENT_WITHOUT_DEFAULT) {
      // Its place is the whole of the parameters, of which nothing is missing.
      return own;
    }
    var around = new Surroundings(error.span().source(), error.span().begin());
    for (Function<Surroundings, @Nullable Advice> rule : RULES) {
      Advice advice = rule.apply(around);
      if (advice != null) {
        return advice.hint() == null ? new Advice(own.hint(), advice.notes()) : advice;
      }
    }
    return own;
  }
}

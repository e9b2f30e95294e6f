package org.urbi.lang.advice;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.grammar.UrbiscriptLexer;
import org.urbi.lang.problem.SyntaxHint;
import org.urbi.lang.source.Span;

/** Strings that were meant to end in an earlier line: the quote that ends them begins another. */
final class StringAdvice {
  private StringAdvice() {}

  /** The string ends directly before the mistake. */
  static @Nullable Advice string(Surroundings around) {
    for (int i = around.at() - 1; i >= Math.max(0, around.at() - 2); i--) {
      if (goesOn(around, i)) {
        return advice(around, i);
      }
    }
    return null;
  }

  /** {@code 'it's'}, {@code o.v'q}: the quote is an operator there. */
  static @Nullable Advice apostrophe(Surroundings around) {
    boolean quote = around.text(around.at() - 1).startsWith("'");
    return quote ? Advice.of(SyntaxHint.QUOTES.text()) : null;
  }

  /** The first string of several lines before a place, at which another one is not closed. */
  static @Nullable Advice before(Surroundings around, int place) {
    for (int i = 0; i < around.at() && around.span(i).begin() < place; i++) {
      if (goesOn(around, i)) {
        return advice(around, i);
      }
    }
    return null;
  }

  private static boolean goesOn(Surroundings around, int index) {
    return around.is(index, UrbiscriptLexer.STRING) && around.lastLine(index) > around.line(index);
  }

  private static Advice advice(Surroundings around, int index) {
    Span whole = around.span(index);
    Span quote = new Span(whole.source(), whole.begin(), whole.begin() + 1);
    String text = SyntaxHint.STRING_BEGINS.text(around.lastLine(index));
    return new Advice(SyntaxHint.QUOTE.text(), List.of(new Note(quote, text)));
  }
}

package org.urbi.lang.advice;

import java.util.Set;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.grammar.UrbiscriptLexer;
import org.urbi.lang.problem.SyntaxHint;

/** Operators of other languages, and operators without operands. */
final class OperatorAdvice {
  private static final Set<Integer> BINARY =
      Set.of(
          UrbiscriptLexer.PLUS,
          UrbiscriptLexer.MINUS,
          UrbiscriptLexer.TIMES,
          UrbiscriptLexer.DIVIDE,
          UrbiscriptLexer.MODULO,
          UrbiscriptLexer.POWER,
          UrbiscriptLexer.ASSIGN,
          UrbiscriptLexer.EQUAL,
          UrbiscriptLexer.NOT_EQUAL,
          UrbiscriptLexer.LESS,
          UrbiscriptLexer.LESS_EQUAL,
          UrbiscriptLexer.GREATER,
          UrbiscriptLexer.GREATER_EQUAL,
          UrbiscriptLexer.SHIFT_LEFT,
          UrbiscriptLexer.SHIFT_RIGHT,
          UrbiscriptLexer.AND_AND,
          UrbiscriptLexer.OR_OR,
          UrbiscriptLexer.DOT,
          UrbiscriptLexer.FAT_ARROW);

  private OperatorAdvice() {}

  /**
   * {@code :=}, {@code <>}, {@code 1..3}, {@code x => …}, {@code x ? 1 : 2}, {@code ["a": 1]},
   * {@code text[0:2]}, {@code if (…):}.
   */
  static @Nullable Advice operator(Surroundings around) {
    int at = around.at();
    SyntaxHint hint = null;
    if (pair(around, at - 1, UrbiscriptLexer.COLON, UrbiscriptLexer.ASSIGN)
        || pair(around, at, UrbiscriptLexer.COLON, UrbiscriptLexer.ASSIGN)) {
      hint = SyntaxHint.ASSIGNMENT;
    } else if (pair(around, at - 1, UrbiscriptLexer.LESS, UrbiscriptLexer.GREATER)) {
      hint = SyntaxHint.DIFFERENT;
    } else if (pair(around, at - 1, UrbiscriptLexer.DOT, UrbiscriptLexer.DOT)
        || pair(around, at, UrbiscriptLexer.DOT, UrbiscriptLexer.DOT)) {
      hint = SyntaxHint.RANGE;
    } else if (around.is(at, UrbiscriptLexer.FAT_ARROW)
        && around.is(at - 1, UrbiscriptLexer.RPAREN, UrbiscriptLexer.WORD)) {
      hint = SyntaxHint.LIKE_FUNCTION;
    } else if (around.is(at, UrbiscriptLexer.QUESTION) && chooses(around, at)) {
      hint = SyntaxHint.NO_CHOICE;
    } else if (around.is(at, UrbiscriptLexer.QUESTION)) {
      hint = SyntaxHint.ONLY_EVENTS;
    } else if (around.is(at, UrbiscriptLexer.COLON)) {
      OpenBracket open = around.innermost();
      if (open != null && open.mark() == '[') {
        hint = isIndex(around, open.token()) ? SyntaxHint.SLICE : SyntaxHint.DICTIONARY;
      } else if (around.is(at - 1, UrbiscriptLexer.RPAREN, UrbiscriptLexer.ELSE)) {
        hint = SyntaxHint.COLON;
      }
    }
    return hint == null ? null : Advice.of(hint.text());
  }

  /** {@code ? 1 : 2}. */
  private static boolean chooses(Surroundings around, int question) {
    int next = question + 1;
    while (!around.is(next, UrbiscriptLexer.COLON, UrbiscriptLexer.SEMICOLON, Token.EOF)) {
      next++;
    }
    return around.is(next, UrbiscriptLexer.COLON);
  }

  /** Whether what stands before a bracket is what it takes an element of. */
  private static boolean isIndex(Surroundings around, int bracket) {
    return around.is(
        bracket - 1,
        UrbiscriptLexer.WORD,
        UrbiscriptLexer.STRING,
        UrbiscriptLexer.RPAREN,
        UrbiscriptLexer.RBRACKET);
  }

  private static boolean pair(Surroundings around, int first, int one, int other) {
    return around.is(first, one) && around.is(first + 1, other) && around.touch(first);
  }

  /** {@code 1 + ;}. */
  static @Nullable Advice operand(Surroundings around) {
    int before = around.at() - 1;
    return BINARY.contains(around.type(before))
        ? Advice.of(SyntaxHint.OPERAND.text(around.text(before)))
        : null;
  }
}

package org.urbi.lang.advice;

import java.util.List;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.grammar.UrbiscriptLexer;
import org.urbi.lang.problem.SyntaxHint;
import org.urbi.lang.source.Span;

/** Separators that are missing, or that are where none may be. */
final class SeparatorAdvice {
  private SeparatorAdvice() {}

  /** {@code if (…) { … }; else { … }}. */
  static @Nullable Advice otherwise(Surroundings around) {
    int at = around.at();
    boolean alone =
        around.is(at, UrbiscriptLexer.ELSE)
            && around.is(at - 1, UrbiscriptLexer.SEMICOLON, UrbiscriptLexer.PIPE, Token.EOF);
    return alone ? Advice.of(SyntaxHint.ELSE.text()) : null;
  }

  /** Two statements, or two elements, in a row. */
  static @Nullable Advice missing(Surroundings around) {
    int at = around.at();
    if (!begins(around, at) || !ends(around, at - 1)) {
      return null;
    }
    OpenBracket open = around.innermost();
    if (open != null && open.mark() != '{') {
      return Advice.of(SyntaxHint.COMMA.text());
    }
    boolean block = around.is(at - 1, UrbiscriptLexer.RBRACE);
    if (around.sameLine(at - 1, at) && !block) {
      if (around.is(at - 1, UrbiscriptLexer.RPAREN)) {
        return null;
      }
      return Advice.of(
          isCall(around, at)
              ? SyntaxHint.ARGUMENTS.text(around.text(at - 1), around.text(at))
              : SyntaxHint.TOGETHER.text());
    }
    return new Advice(
        SyntaxHint.SEPARATOR.text(),
        List.of(new Note(last(around.span(at - 1)), SyntaxHint.ENDS.text())));
  }

  /** {@code echo "text"}. */
  private static boolean isCall(Surroundings around, int argument) {
    return around.is(argument, UrbiscriptLexer.STRING)
        && around.is(argument - 1, UrbiscriptLexer.WORD)
        && around.statement(argument) == argument - 1;
  }

  private static Span last(Span span) {
    return new Span(span.source(), Math.max(span.begin(), span.end() - 1), span.end());
  }

  private static boolean begins(Surroundings around, int index) {
    return around.is(
        index,
        UrbiscriptLexer.WORD,
        UrbiscriptLexer.QUOTED,
        UrbiscriptLexer.NUMBER,
        UrbiscriptLexer.DURATION,
        UrbiscriptLexer.STRING,
        UrbiscriptLexer.VAR,
        UrbiscriptLexer.CONST,
        UrbiscriptLexer.FUNCTION,
        UrbiscriptLexer.CLASS,
        UrbiscriptLexer.IF,
        UrbiscriptLexer.FOR,
        UrbiscriptLexer.WHILE,
        UrbiscriptLexer.LOOP,
        UrbiscriptLexer.AT,
        UrbiscriptLexer.WHENEVER,
        UrbiscriptLexer.EVERY,
        UrbiscriptLexer.TIMEOUT,
        UrbiscriptLexer.WAITUNTIL,
        UrbiscriptLexer.SWITCH,
        UrbiscriptLexer.TRY,
        UrbiscriptLexer.THROW,
        UrbiscriptLexer.RETURN,
        UrbiscriptLexer.BREAK,
        UrbiscriptLexer.CONTINUE,
        UrbiscriptLexer.THIS,
        UrbiscriptLexer.ASSERT);
  }

  private static boolean ends(Surroundings around, int index) {
    return around.is(
        index,
        UrbiscriptLexer.WORD,
        UrbiscriptLexer.QUOTED,
        UrbiscriptLexer.NUMBER,
        UrbiscriptLexer.DURATION,
        UrbiscriptLexer.STRING,
        UrbiscriptLexer.RPAREN,
        UrbiscriptLexer.RBRACKET,
        UrbiscriptLexer.RBRACE,
        UrbiscriptLexer.BREAK,
        UrbiscriptLexer.CONTINUE,
        UrbiscriptLexer.RETURN,
        UrbiscriptLexer.THIS);
  }

  /** {@code max(1; 2)}, {@code echo((1 + 2);}. */
  static @Nullable Advice semicolon(Surroundings around) {
    OpenBracket open = around.innermost();
    if (!around.is(around.at(), UrbiscriptLexer.SEMICOLON) || open == null || open.mark() == '{') {
      return null;
    }
    return new Advice(
        SyntaxHint.NO_SEMICOLON.text(open.closer()), List.of(BracketAdvice.opened(around, open)));
  }
}

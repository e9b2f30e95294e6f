package org.urbi.lang.advice;

import java.util.List;
import java.util.Map;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.grammar.UrbiscriptLexer;
import org.urbi.lang.problem.SyntaxHint;
import org.urbi.lang.source.Span;

/** Separators that are missing, or that are where none may be. */
final class SeparatorAdvice {
  /** What is called without parentheses elsewhere, and what that is called here. */
  private static final Map<String, String> FUNCTIONS =
      Map.ofEntries(
          Map.entry("echo", "echo"),
          Map.entry("print", "echo"),
          Map.entry("println", "echo"),
          Map.entry("puts", "echo"),
          Map.entry("load", "load"),
          Map.entry("include", "load"),
          Map.entry("require", "load"),
          Map.entry("loadModule", "loadModule"),
          Map.entry("sleep", "sleep"));

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
      return Advice.of(together(around, at));
    }
    return new Advice(
        SyntaxHint.SEPARATOR.text(),
        List.of(new Note(last(around.span(at - 1)), SyntaxHint.ENDS.text())));
  }

  /** {@code echo "text"}, {@code echo text}, {@code print "text"}, {@code x = 1 y}. */
  private static String together(Surroundings around, int at) {
    String word = around.text(at - 1);
    String argument = around.text(at);
    String call = FUNCTIONS.get(word);
    boolean calls = around.is(at - 1, UrbiscriptLexer.WORD) && around.statement(at) == at - 1;
    if (!calls || call == null && !around.is(at, UrbiscriptLexer.STRING)) {
      return SyntaxHint.TOGETHER.text();
    } else if (call != null && !call.equals(word)) {
      return SyntaxHint.NO_WORD.text(word, call + "(" + argument + ")");
    }
    return word.equals("echo") && around.is(at, UrbiscriptLexer.WORD)
        ? SyntaxHint.VALUE_OR_TEXT.text(word, argument, word, argument)
        : SyntaxHint.ARGUMENTS.text(word, argument);
  }

  private static Span last(Span span) {
    return new Span(span.source(), Math.max(span.begin(), span.end() - 1), span.end());
  }

  /** Whether a statement or an element may begin so. */
  static boolean begins(Surroundings around, int index) {
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

  /** Whether a value may end so. */
  static boolean ends(Surroundings around, int index) {
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

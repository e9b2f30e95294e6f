package org.urbi.lang.advice;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.grammar.LexicalError;
import org.urbi.lang.grammar.UrbiscriptLexer;
import org.urbi.lang.problem.SyntaxHint;
import org.urbi.lang.problem.SyntaxProblem;

/** Brackets, quotes and comments that are not closed, not opened, or not there. */
final class BracketAdvice {
  /** What stands behind these words is in parentheses. */
  private static final Set<Integer> WITH_PARENTHESES =
      Set.of(
          UrbiscriptLexer.IF,
          UrbiscriptLexer.WHILE,
          UrbiscriptLexer.FOR,
          UrbiscriptLexer.SWITCH,
          UrbiscriptLexer.AT,
          UrbiscriptLexer.WHENEVER,
          UrbiscriptLexer.WAITUNTIL,
          UrbiscriptLexer.EVERY,
          UrbiscriptLexer.TIMEOUT,
          UrbiscriptLexer.STOPIF,
          UrbiscriptLexer.FREEZEIF,
          UrbiscriptLexer.CATCH,
          UrbiscriptLexer.DO,
          UrbiscriptLexer.WATCH);

  /** What follows these words is in braces. */
  private static final Map<Integer, SyntaxHint> WITH_BRACES =
      Map.of(
          UrbiscriptLexer.CATCH, SyntaxHint.BLOCK,
          UrbiscriptLexer.FUNCTION, SyntaxHint.BLOCK,
          UrbiscriptLexer.CLOSURE, SyntaxHint.BLOCK,
          UrbiscriptLexer.DO, SyntaxHint.BLOCK,
          UrbiscriptLexer.CLASS, SyntaxHint.BLOCK,
          UrbiscriptLexer.FINALLY, SyntaxHint.BLOCK,
          UrbiscriptLexer.TRY, SyntaxHint.BLOCK,
          UrbiscriptLexer.SWITCH, SyntaxHint.CASES);

  private BracketAdvice() {}

  /** The text ends within a string, a comment or brackets. */
  static @Nullable Advice unfinished(Surroundings around) {
    for (LexicalError issue : around.issues()) {
      if (issue.problem() == SyntaxProblem.OPEN_STRING
          || issue.problem() == SyntaxProblem.OPEN_NAME
          || issue.problem() == SyntaxProblem.OPEN_COMMENT) {
        Advice earlier = StringAdvice.before(around, issue.begin());
        if (issue.problem() == SyntaxProblem.OPEN_STRING && earlier != null) {
          return earlier;
        }
        return new Advice(
            issue.problem().hint().orElse(null),
            List.of(new Note(around.span(issue), SyntaxHint.OPENED.text())));
      }
    }
    OpenBracket open = around.innermost();
    if (around.type(around.at()) != Token.EOF || open == null) {
      return null;
    }
    OpenBracket suspect = around.suspect();
    return suspect == null
        ? unclosed(around, open)
        : new Advice(
            SyntaxHint.UNCLOSED.text(suspect.closer()),
            List.of(
                opened(around, suspect),
                new Note(
                    around.span(around.suspectCloser()),
                    SyntaxHint.INDENTED.text(suspect.closer()))));
  }

  private static Advice unclosed(Surroundings around, OpenBracket open) {
    return new Advice(SyntaxHint.UNCLOSED.text(open.closer()), List.of(opened(around, open)));
  }

  /** Where a bracket was opened. */
  static Note opened(Surroundings around, OpenBracket open) {
    return new Note(around.span(open.token()), SyntaxHint.OPENED.text());
  }

  /** A bracket closes what is not open. */
  static @Nullable Advice closer(Surroundings around) {
    if (!around.is(
        around.at(), UrbiscriptLexer.RBRACE, UrbiscriptLexer.RPAREN, UrbiscriptLexer.RBRACKET)) {
      return null;
    }
    OpenBracket open = around.innermost();
    String closer = around.text(around.at());
    if (open == null) {
      return Advice.of(SyntaxHint.UNOPENED.text(closer));
    }
    return closer.equals(String.valueOf(open.closer())) ? null : unclosed(around, open);
  }

  /** {@code if (x == 1 echo(x)}, {@code while (x < 3 { … }}, {@code for (var x : list echo(x)}. */
  static @Nullable Advice condition(Surroundings around) {
    int at = around.at();
    OpenBracket open = around.innermost();
    if (open == null
        || open.mark() != '('
        || !WITH_PARENTHESES.contains(around.type(open.token() - 1))
        || !(SeparatorAdvice.ends(around, at - 1)
            || around.is(at - 1, UrbiscriptLexer.INCREMENT, UrbiscriptLexer.DECREMENT))
        || !(SeparatorAdvice.begins(around, at) || around.is(at, UrbiscriptLexer.LBRACE))
        || WordAdvice.joins(around.text(at))
        || WordAdvice.joins(around.text(at - 1))) {
      return null;
    }
    return unclosed(around, open);
  }

  /** {@code if x > 1 …}, {@code at () …}. */
  static @Nullable Advice parentheses(Surroundings around) {
    int at = around.at();
    if (around.is(at, UrbiscriptLexer.RPAREN)
        && around.is(at - 1, UrbiscriptLexer.LPAREN)
        && WITH_PARENTHESES.contains(around.type(at - 2))) {
      return Advice.of(SyntaxHint.NOTHING.text(around.text(at - 2)));
    }
    int first = around.statement(around.at());
    for (int i = around.at(); i >= first; i--) {
      if (WITH_PARENTHESES.contains(around.type(i))) {
        if (around.is(i, UrbiscriptLexer.FOR) && isOver(around, i)) {
          return Advice.of(SyntaxHint.LOOP.text());
        }
        return around.is(i + 1, UrbiscriptLexer.LPAREN) || i == around.at()
            ? null
            : Advice.of(SyntaxHint.PARENTHESES.text(around.text(i), around.text(i)));
      }
    }
    return null;
  }

  /** {@code for x in list}. */
  private static boolean isOver(Surroundings around, int loop) {
    for (int i = loop + 2; i <= Math.min(loop + 4, around.at() + 1); i++) {
      if (around.text(i).equals("in")) {
        return true;
      }
    }
    return false;
  }

  /** {@code catch (var e) echo(e)}, {@code try { … };}, {@code do { … } while (…)}. */
  static @Nullable Advice braces(Surroundings around) {
    int at = around.at();
    if (around.is(at - 1, UrbiscriptLexer.RBRACE)) {
      return behindBlock(around, at);
    }
    int first = around.statement(at);
    for (int i = at - 1; i >= first; i--) {
      SyntaxHint hint = WITH_BRACES.get(around.type(i));
      if (hint != null) {
        return Advice.of(
            hint == SyntaxHint.BLOCK ? hint.text(around.text(i), around.text(i)) : hint.text());
      }
    }
    OpenBracket open = around.innermost();
    boolean inCase = open != null && open.mark() == '{' && around.is(first, UrbiscriptLexer.CASE);
    return inCase ? Advice.of(SyntaxHint.CASE_COLON.text()) : null;
  }

  private static @Nullable Advice behindBlock(Surroundings around, int at) {
    int depth = 0;
    int opener = at - 1;
    for (; opener >= 0; opener--) {
      if (around.is(opener, UrbiscriptLexer.RBRACE)) {
        depth++;
      } else if (around.is(opener, UrbiscriptLexer.LBRACE) && --depth == 0) {
        break;
      }
    }
    if (around.is(opener - 1, UrbiscriptLexer.TRY)) {
      return Advice.of(SyntaxHint.CATCH.text());
    }
    return around.is(opener - 1, UrbiscriptLexer.DO) && around.is(at, UrbiscriptLexer.WHILE)
        ? Advice.of(SyntaxHint.NO_DO_WHILE.text())
        : null;
  }
}

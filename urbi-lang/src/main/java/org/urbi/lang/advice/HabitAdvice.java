package org.urbi.lang.advice;

import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.grammar.Keywords;
import org.urbi.lang.grammar.LexicalError;
import org.urbi.lang.grammar.UrbiscriptLexer;
import org.urbi.lang.problem.SyntaxHint;
import org.urbi.lang.problem.SyntaxProblem;
import org.urbi.lang.text.StringDistance;

/** What is written so in C++, Python or Lua, and otherwise here. */
final class HabitAdvice {
  private static final String SPELLED_UNITS = "ms|us|ns|s|secs?|seconds?|min|minutes?|h|hours?|d";

  private HabitAdvice() {}

  /** {@code # text}, {@code -- text}, {@code #include "x.u"}, {@code 7 // 2;}. */
  static @Nullable Advice comment(Surroundings around) {
    for (LexicalError issue : around.issues()) {
      String rest = around.span(issue).source().text().substring(issue.begin());
      if (issue.problem() == SyntaxProblem.INVALID_CHARACTER && rest.startsWith("#")) {
        return Advice.of(
            (rest.startsWith("#include") ? SyntaxHint.INCLUDE : SyntaxHint.COMMENT).text());
      }
    }
    int at = around.at();
    if (around.is(at, UrbiscriptLexer.DECREMENT) && around.statement(at) == at) {
      return Advice.of(SyntaxHint.COMMENT.text());
    }
    return around.is(at, Token.EOF)
            && around.innermost() == null
            && around.behind(at - 1).matches("(?s)[ \t]*//[^\n]*;\\s*")
        ? Advice.of(SyntaxHint.COMMENTED_OUT.text())
        : null;
  }

  /** {@code f(int x)}, {@code var x: int}, {@code int("3")}, {@code void f()}. */
  static @Nullable Advice type(Surroundings around) {
    int at = around.at();
    boolean reserved =
        around.issues().stream().anyMatch(each -> each.problem() == SyntaxProblem.RESERVED_WORD);
    if (around.is(at, UrbiscriptLexer.WORD) && around.text(around.statement(at)).equals("void")) {
      return Advice.of(SyntaxHint.NO_WORD.text("void", "function"));
    } else if (!reserved) {
      return null;
    }
    boolean declared =
        around.is(at - 1, UrbiscriptLexer.COLON) && around.is(at - 3, UrbiscriptLexer.VAR);
    if (declared || isParameter(around)) {
      return Advice.of(SyntaxHint.NO_TYPES.text());
    }
    boolean converts =
        around.is(at + 1, UrbiscriptLexer.LPAREN) && around.text(at).matches("int|float|double");
    return converts ? Advice.of(SyntaxHint.CONVERSION.text()) : null;
  }

  private static boolean isParameter(Surroundings around) {
    OpenBracket open = around.innermost();
    return open != null
        && open.mark() == '('
        && (around.is(open.token() - 1, UrbiscriptLexer.FUNCTION)
            || around.is(around.statement(open.token()), UrbiscriptLexer.FUNCTION));
  }

  /** {@code class A extends B}, {@code class A(B)}, {@code function A::f()}. */
  static @Nullable Advice declaration(Surroundings around) {
    int at = around.at();
    int first = around.statement(at);
    if (around.is(first, UrbiscriptLexer.CLASS) && around.is(first + 1, UrbiscriptLexer.WORD)) {
      boolean parents = around.is(first + 2, UrbiscriptLexer.LPAREN, UrbiscriptLexer.WORD);
      return parents ? Advice.of(SyntaxHint.PROTOTYPE.text(around.text(first + 1))) : null;
    }
    boolean joined =
        around.is(at, UrbiscriptLexer.COLON)
            && around.is(at + 1, UrbiscriptLexer.COLON)
            && around.touch(at);
    return joined && around.is(at - 1, UrbiscriptLexer.WORD)
        ? Advice.of(SyntaxHint.JOINED_NAMES.text(around.text(at - 1), around.text(at + 2)))
        : null;
  }

  /** {@code f"{x}"}, {@code "a" .. "b"}, {@code 500 ms}, {@code {"a" => 1}}. */
  static @Nullable Advice value(Surroundings around) {
    int at = around.at();
    if (around.is(at, UrbiscriptLexer.STRING)
        && around.text(at - 1).equals("f")
        && around.touch(at - 1)) {
      return Advice.of(SyntaxHint.FORMAT.text());
    } else if (around.is(at, UrbiscriptLexer.DOT)
        && around.is(at - 1, UrbiscriptLexer.DOT)
        && around.is(at - 2, UrbiscriptLexer.STRING)) {
      return Advice.of(SyntaxHint.CONCATENATION.text());
    } else if (around.is(at, UrbiscriptLexer.WORD)
        && around.is(at - 1, UrbiscriptLexer.NUMBER)
        && around.text(at).matches(SPELLED_UNITS)) {
      return Advice.of(SyntaxHint.UNIT_TOUCHES.text());
    }
    OpenBracket open = around.innermost();
    return around.is(at, UrbiscriptLexer.FAT_ARROW) && open != null && open.mark() == '{'
        ? Advice.of(SyntaxHint.DICTIONARY.text())
        : null;
  }

  /**
   * {@code x = 1 if …}, {@code for (…, …, …)}, {@code onleve}, {@code catch (Exception e)}, {@code
   * assert x}, {@code detach { … }}, {@code case 1: …; break}.
   */
  static @Nullable Advice statement(Surroundings around) {
    int at = around.at();
    int first = around.statement(at);
    OpenBracket open = around.innermost();
    if (around.is(at, UrbiscriptLexer.IF)
        && first != at
        && !around.is(at - 1, UrbiscriptLexer.ELSE)
        && around.sameLine(at - 1, at)) {
      return Advice.of(SyntaxHint.IF_FIRST.text());
    } else if (around.is(at, UrbiscriptLexer.ELSE) && around.is(first, UrbiscriptLexer.AT)) {
      return Advice.of(SyntaxHint.ONLEAVE.text());
    } else if (open != null && open.mark() == '(') {
      return inParentheses(around, open.token() - 1);
    } else if (around.is(at - 1, UrbiscriptLexer.ASSERT)) {
      return Advice.of(SyntaxHint.ARGUMENTS.text("assert", "x == 1"));
    } else if (around.is(at, UrbiscriptLexer.LBRACE) && around.text(at - 1).equals("detach")) {
      return Advice.of(SyntaxHint.ARGUMENTS.text("detach", "{ … }"));
    } else if (around.is(at, UrbiscriptLexer.BREAK) && inSwitch(around, open)) {
      return Advice.of(SyntaxHint.NO_BREAK.text());
    }
    return around.is(at, UrbiscriptLexer.WORD)
            && around.is(first, UrbiscriptLexer.AT)
            && isNear(around.text(at), "onleave")
        ? Advice.of(SyntaxHint.MISSPELLED.text("onleave"))
        : null;
  }

  private static @Nullable Advice inParentheses(Surroundings around, int before) {
    int at = around.at();
    if (around.is(at, UrbiscriptLexer.COMMA) && around.is(before, UrbiscriptLexer.ASSERT)) {
      return Advice.of(SyntaxHint.ASSERT_MESSAGE.text());
    } else if (around.is(at, UrbiscriptLexer.COMMA) && around.is(before, UrbiscriptLexer.FOR)) {
      return Advice.of(SyntaxHint.LOOP_PARTS.text());
    } else if (isElement(around, before)) {
      return Advice.of(SyntaxHint.LOOP.text());
    }
    return around.is(at, UrbiscriptLexer.WORD) && around.is(before, UrbiscriptLexer.CATCH)
        ? Advice.of(SyntaxHint.CAUGHT.text(around.text(at)))
        : null;
  }

  /** {@code for (x : list)}, {@code for (Item x : list)}, {@code for (x of list)}. */
  private static boolean isElement(Surroundings around, int loop) {
    boolean twoWords =
        around.is(loop + 2, UrbiscriptLexer.WORD) && around.is(loop + 3, UrbiscriptLexer.WORD);
    return around.is(loop, UrbiscriptLexer.FOR)
        && (around.is(around.at(), UrbiscriptLexer.COLON) || twoWords);
  }

  private static boolean inSwitch(Surroundings around, @Nullable OpenBracket open) {
    return open != null
        && open.mark() == '{'
        && around.is(around.statement(open.token()), UrbiscriptLexer.SWITCH);
  }

  private static boolean isNear(String word, String keyword) {
    var closest = new StringDistance.ClosestName(word);
    closest.consider(keyword);
    return closest.meant() != null;
  }

  /**
   * {@code [i * 2 for …]}, {@code f(*list)}, {@code f(...list)}, {@code constructor() { … }} in a
   * class.
   */
  static @Nullable Advice nested(Surroundings around) {
    int at = around.at();
    OpenBracket open = around.innermost();
    if (open == null) {
      return null;
    }
    int before = open.token() - 1;
    boolean begins = at == open.token() + 1;
    if (around.is(at, UrbiscriptLexer.FOR) && open.mark() == '[') {
      return Advice.of(SyntaxHint.COMPREHENSION.text());
    } else if (begins
        && around.is(at, UrbiscriptLexer.TIMES, UrbiscriptLexer.POWER, UrbiscriptLexer.DOT)
        && around.is(before, UrbiscriptLexer.WORD)) {
      return Advice.of(SyntaxHint.ARGUMENT_LIST.text(around.text(before)));
    }
    int first = around.statement(at);
    return around.is(at, UrbiscriptLexer.LBRACE)
            && around.is(at - 1, UrbiscriptLexer.RPAREN)
            && around.is(first, UrbiscriptLexer.WORD)
            && open.mark() == '{'
            && around.is(around.statement(open.token()), UrbiscriptLexer.CLASS)
        ? Advice.of(SyntaxHint.METHOD.text(around.text(first)))
        : null;
  }

  /** {@code var at}, {@code object.every}, {@code f(every)}. */
  static @Nullable Advice name(Surroundings around) {
    int at = around.at();
    boolean wanted =
        around.is(at - 1, UrbiscriptLexer.VAR, UrbiscriptLexer.DOT)
            || isParameter(around)
                && around.is(at - 1, UrbiscriptLexer.LPAREN, UrbiscriptLexer.COMMA);
    return wanted && Keywords.all().contains(around.text(at))
        ? Advice.of(SyntaxHint.KEYWORD.text(around.text(at)))
        : null;
  }
}

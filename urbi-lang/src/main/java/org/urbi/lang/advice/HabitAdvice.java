package org.urbi.lang.advice;

import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
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

  /** What other languages have before functions, and a function that replaces another lacks. */
  private static final Set<String> NEEDLESS =
      Set.of("override", "virtual", "final", "abstract", "async");

  /** These words are left out by the scanner. */
  private static final Pattern ACCESS = Pattern.compile("\\b(public|protected|private)\\s*$");

  /** How far before a place a word is looked for. */
  private static final int LOOK_BACK = 16;

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

  /**
   * {@code class A extends B}, {@code class A(B)}, {@code function A::f()}, {@code override
   * function f()}, {@code public:}, {@code import * from a}.
   */
  static @Nullable Advice declaration(Surroundings around) {
    int at = around.at();
    int first = around.statement(at);
    if (around.is(first, UrbiscriptLexer.CLASS) && around.is(first + 1, UrbiscriptLexer.WORD)) {
      boolean parents = around.is(first + 2, UrbiscriptLexer.LPAREN, UrbiscriptLexer.WORD);
      return parents ? Advice.of(SyntaxHint.PROTOTYPE.text(around.text(first + 1))) : null;
    }
    int word = around.is(at, UrbiscriptLexer.FUNCTION) ? at - 1 : at;
    if (NEEDLESS.contains(around.text(word)) && around.is(word + 1, UrbiscriptLexer.FUNCTION)) {
      return Advice.of(SyntaxHint.NEEDLESS.text(around.text(word)));
    }
    Matcher access = ACCESS.matcher(around.before(at, LOOK_BACK));
    if (around.is(at, UrbiscriptLexer.COLON) && access.find()) {
      return Advice.of(SyntaxHint.ACCESS.text(access.group(1)));
    } else if (around.is(first, UrbiscriptLexer.IMPORT)) {
      return imported(around);
    }
    boolean joined =
        around.is(at, UrbiscriptLexer.COLON)
            && around.is(at + 1, UrbiscriptLexer.COLON)
            && around.touch(at);
    return joined && around.is(at - 1, UrbiscriptLexer.WORD)
        ? Advice.of(SyntaxHint.JOINED_NAMES.text(around.text(at - 1), around.text(at + 2)))
        : null;
  }

  /** {@code import * from a}, {@code import a from a}, {@code import "a.u"}. */
  private static @Nullable Advice imported(Surroundings around) {
    int at = around.at();
    if (around.is(at, UrbiscriptLexer.STRING)) {
      return Advice.of(SyntaxHint.INCLUDE.text());
    }
    int from = around.text(at).equals("from") ? at : at - 1;
    return around.text(from).equals("from") && around.is(from + 1, UrbiscriptLexer.WORD)
        ? Advice.of(SyntaxHint.IMPORTED.text(around.text(from + 1), around.text(from + 1)))
        : null;
  }

  /**
   * {@code f"{x}"}, {@code "a" .. "b"}, {@code 500 ms}, {@code 10 mod 3}, {@code {"a" => 1}},
   * {@code ["a" => 1, "b"]}, {@code at (e? => x)}.
   */
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
    } else if (around.text(at).equals("mod") && SeparatorAdvice.ends(around, at - 1)) {
      return Advice.of(SyntaxHint.NO_WORD.text("mod", "%"));
    } else if (around.is(at, UrbiscriptLexer.FAT_ARROW)
        && around.is(at - 1, UrbiscriptLexer.QUESTION)) {
      return Advice.of(SyntaxHint.CARRIED.text());
    }
    OpenBracket open = around.innermost();
    if (open != null && open.mark() == '[' && isMixed(around, open)) {
      return Advice.of(SyntaxHint.DICTIONARY_PAIRS.text());
    }
    return around.is(at, UrbiscriptLexer.FAT_ARROW) && open != null && open.mark() == '{'
        ? Advice.of(SyntaxHint.DICTIONARY.text())
        : null;
  }

  /** {@code ["a" => 1, "b"]}, {@code [1, "b" => 2]}. */
  private static boolean isMixed(Surroundings around, OpenBracket list) {
    int at = around.at();
    return around.is(at, UrbiscriptLexer.FAT_ARROW)
        ? around.holds(list, UrbiscriptLexer.COMMA) && SeparatorAdvice.ends(around, at - 1)
        : around.is(at, UrbiscriptLexer.RBRACKET, UrbiscriptLexer.COMMA)
            && around.holds(list, UrbiscriptLexer.FAT_ARROW)
            && SeparatorAdvice.ends(around, at - 1);
  }

  /**
   * {@code x = 1 if …}, {@code for (…, …, …)}, {@code onleve}, {@code catch (Exception e)}, {@code
   * assert x}, {@code detach { … }}, {@code case 1: …; break}, {@code else: …} in a switch.
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
      return inParentheses(around, open);
    } else if (around.is(at - 1, UrbiscriptLexer.ASSERT)) {
      return Advice.of(SyntaxHint.ARGUMENTS.text("assert", "x == 1"));
    } else if (around.is(at, UrbiscriptLexer.LBRACE) && around.text(at - 1).equals("detach")) {
      return Advice.of(SyntaxHint.ARGUMENTS.text("detach", "{ … }"));
    } else if (around.is(at, UrbiscriptLexer.ELSE)
        && around.is(at + 1, UrbiscriptLexer.COLON)
        && inSwitch(around, open)) {
      return Advice.of(SyntaxHint.DEFAULT.text());
    } else if (around.is(at, UrbiscriptLexer.BREAK) && inSwitch(around, open)) {
      return Advice.of(SyntaxHint.NO_BREAK.text());
    }
    return around.is(at, UrbiscriptLexer.WORD)
            && around.is(first, UrbiscriptLexer.AT)
            && isNear(around.text(at), "onleave")
        ? Advice.of(SyntaxHint.MISSPELLED.text("onleave"))
        : null;
  }

  private static @Nullable Advice inParentheses(Surroundings around, OpenBracket open) {
    int at = around.at();
    int before = open.token() - 1;
    if (around.is(at, UrbiscriptLexer.COMMA) && around.is(before, UrbiscriptLexer.ASSERT)) {
      return Advice.of(SyntaxHint.ASSERT_MESSAGE.text());
    } else if (around.is(before, UrbiscriptLexer.FOR)) {
      return loop(around, open);
    } else if (around.is(before, UrbiscriptLexer.WORD)) {
      return argument(around);
    } else if (!around.is(before, UrbiscriptLexer.CATCH)) {
      return null;
    }
    return around.is(at, UrbiscriptLexer.WORD)
        ? Advice.of(SyntaxHint.CAUGHT.text(around.text(at)))
        : around.is(at, UrbiscriptLexer.DOT) ? Advice.of(SyntaxHint.CATCH_ALL.text()) : null;
  }

  /** {@code f(x: 1)}, {@code map((x) { … })}. */
  private static @Nullable Advice argument(Surroundings around) {
    int at = around.at();
    int first = around.statement(at);
    if (around.is(at, UrbiscriptLexer.COLON)
        && first == at - 1
        && around.is(first, UrbiscriptLexer.WORD)) {
      return Advice.of(SyntaxHint.NAMED_ARGUMENTS.text());
    }
    boolean nameless =
        around.is(at, UrbiscriptLexer.LBRACE)
            && around.is(at - 1, UrbiscriptLexer.RPAREN)
            && around.is(first, UrbiscriptLexer.LPAREN);
    return nameless ? Advice.of(SyntaxHint.LIKE_FUNCTION.text()) : null;
  }

  /**
   * {@code for (…, …, …)}, {@code for (var k, v : d)}, {@code for (int i = 0; …)}, {@code for (var
   * i = 0 i < 3 …)}.
   */
  private static @Nullable Advice loop(Surroundings around, OpenBracket open) {
    int at = around.at();
    int loop = open.token() - 1;
    if (around.is(at, UrbiscriptLexer.COMMA)) {
      int second = around.is(at + 1, UrbiscriptLexer.VAR) ? at + 2 : at + 1;
      boolean pairs =
          around.is(second + 1, UrbiscriptLexer.COLON) || around.text(second + 1).equals("in");
      return Advice.of((pairs ? SyntaxHint.LOOP_PAIRS : SyntaxHint.LOOP_PARTS).text());
    } else if (around.is(loop + 2, UrbiscriptLexer.WORD)
        && around.is(loop + 3, UrbiscriptLexer.WORD)
        && around.is(loop + 4, UrbiscriptLexer.ASSIGN)) {
      return Advice.of(SyntaxHint.LOOP_COUNTS.text());
    } else if (around.is(loop + 2, UrbiscriptLexer.VAR)
        && around.is(loop + 4, UrbiscriptLexer.ASSIGN)
        && !around.is(at, UrbiscriptLexer.SEMICOLON)
        && !around.holds(open, UrbiscriptLexer.SEMICOLON)) {
      return Advice.of(SyntaxHint.LOOP_PARTS.text());
    }
    return isElement(around, loop) ? Advice.of(SyntaxHint.LOOP.text()) : null;
  }

  /** {@code for (x : list)}, {@code for (Item x : list)}, {@code for (x of list)}. */
  private static boolean isElement(Surroundings around, int loop) {
    boolean twoWords =
        around.is(loop + 2, UrbiscriptLexer.WORD) && around.is(loop + 3, UrbiscriptLexer.WORD);
    return around.is(around.at(), UrbiscriptLexer.COLON) || twoWords;
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

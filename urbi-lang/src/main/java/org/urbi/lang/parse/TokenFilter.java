package org.urbi.lang.parse;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.WritableToken;
import org.urbi.lang.grammar.UrbiLexer;

/**
 * Tells apart words that are written alike: {@code e!} from {@code !e}, the names of a trajectory's
 * modifiers, flavors from separators, and the colons of {@code case} and {@code for}. One pass, so
 * that the grammar needs no look-ahead for them.
 */
final class TokenFilter {
  private static final Set<Integer> FLAVORED =
      Set.of(
          UrbiLexer.AT,
          UrbiLexer.EVERY,
          UrbiLexer.FOR,
          UrbiLexer.LOOP,
          UrbiLexer.WHENEVER,
          UrbiLexer.WHILE);
  private static final Set<Integer> SEPARATORS =
      Set.of(UrbiLexer.SEMI, UrbiLexer.COMMA, UrbiLexer.PIPE, UrbiLexer.AMP);

  /** What a parenthesis may follow without being part of an expression. */
  private static final Set<Integer> HEADS =
      Set.of(
          UrbiLexer.AT,
          UrbiLexer.CATCH,
          UrbiLexer.DO,
          UrbiLexer.EVERY,
          UrbiLexer.FLAVOR,
          UrbiLexer.FOR,
          UrbiLexer.FREEZEIF,
          UrbiLexer.IF,
          UrbiLexer.STOPIF,
          UrbiLexer.SWITCH,
          UrbiLexer.TIMEOUT,
          UrbiLexer.WHENEVER,
          UrbiLexer.WHILE);

  /** What an expression may end with. */
  private static final Set<Integer> ENDS =
      Set.of(
          UrbiLexer.ANGLE,
          UrbiLexer.CALL,
          UrbiLexer.DERIVATIVE,
          UrbiLexer.DURATION,
          UrbiLexer.FLOAT,
          UrbiLexer.IDENTIFIER,
          UrbiLexer.NEW,
          UrbiLexer.QUOTED,
          UrbiLexer.RBRACKET,
          UrbiLexer.RPAREN,
          UrbiLexer.STRING,
          UrbiLexer.THIS);

  private static final Set<String> MODIFIERS =
      Set.of(
          "accel",
          "adaptive",
          "ampli",
          "cos",
          "getPhase",
          "phase",
          "sin",
          "smooth",
          "speed",
          "time");

  /** An open bracket: whether it heads a statement, and the colon it waits for (or 0). */
  private record Bracket(boolean head, int colon) {}

  private final List<? extends Token> tokens;
  private final Deque<Bracket> brackets = new ArrayDeque<>();

  /** The last token is that closing a statement's head. */
  private boolean afterHead;

  private TokenFilter(List<? extends Token> tokens) {
    this.tokens = tokens;
  }

  static void filter(List<? extends Token> tokens) {
    new TokenFilter(tokens).run();
  }

  private void run() {
    brackets.push(new Bracket(false, 0));
    for (int i = 0; i < tokens.size(); i++) {
      boolean head = false;
      switch (type(i)) {
        case UrbiLexer.LPAREN -> {
          boolean isHead =
              HEADS.contains(type(i - 1))
                  || type(i - 1) == UrbiLexer.IDENTIFIER && type(i - 2) == UrbiLexer.AT;
          boolean loop =
              type(i - 1) == UrbiLexer.FOR
                  || type(i - 1) == UrbiLexer.FLAVOR && type(i - 2) == UrbiLexer.FOR;
          brackets.push(new Bracket(isHead, loop ? UrbiLexer.RANGE_COLON : 0));
        }
        case UrbiLexer.LBRACKET, UrbiLexer.LBRACE -> brackets.push(new Bracket(false, 0));
        case UrbiLexer.RPAREN, UrbiLexer.RBRACKET, UrbiLexer.RBRACE -> {
          if (brackets.size() > 1) {
            head = brackets.pop().head();
          }
        }
        case UrbiLexer.CASE -> {
          brackets.pop();
          brackets.push(new Bracket(false, UrbiLexer.PATTERN_COLON));
        }
        case UrbiLexer.COLON -> {
          if (brackets.peek().colon() != 0) {
            Bracket old = brackets.pop();
            brackets.push(new Bracket(old.head(), 0));
            become(i, old.colon());
          }
        }
        case UrbiLexer.SEMI, UrbiLexer.COMMA, UrbiLexer.PIPE, UrbiLexer.AMP -> {
          if (FLAVORED.contains(type(i - 1))) {
            become(i, UrbiLexer.FLAVOR);
          }
        }
        case UrbiLexer.BANG -> {
          if (afterExpression(i) && tokens.get(i).getText().equals("!")) {
            become(i, UrbiLexer.EMIT);
          }
        }
        case UrbiLexer.IDENTIFIER -> identifier(i);
        default -> {}
      }
      afterHead = head;
    }
  }

  private void identifier(int i) {
    String text = tokens.get(i).getText();
    boolean colon = type(i + 1) == UrbiLexer.COLON && brackets.peek().colon() == 0;
    if (colon
        && (afterExpression(i) || type(i - 1) == UrbiLexer.ASSIGN && MODIFIERS.contains(text))) {
      become(i, UrbiLexer.MODIFIER);
    } else if ((text.equals("get") || text.equals("set"))
        && (type(i + 1) == UrbiLexer.IDENTIFIER
            || type(i + 1) == UrbiLexer.QUOTED
            || type(i + 1) == UrbiLexer.NEW
            || type(i + 1) == UrbiLexer.THIS)) {
      become(i, text.equals("get") ? UrbiLexer.GET : UrbiLexer.SET);
    }
  }

  private boolean afterExpression(int i) {
    return !afterHead && ENDS.contains(type(i - 1));
  }

  private int type(int i) {
    return i < 0 || i >= tokens.size() ? Token.EOF : tokens.get(i).getType();
  }

  private void become(int i, int type) {
    ((WritableToken) tokens.get(i)).setType(type);
  }
}

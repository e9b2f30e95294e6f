package org.urbi.lang.input;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.grammar.Keywords;
import org.urbi.lang.grammar.TextStream;
import org.urbi.lang.grammar.UrbiscriptLexer;
import org.urbi.lang.text.StatementSplitter;

/**
 * A text that somebody is typing, up to the cursor, and what may follow there: a name, of a slot of
 * something or of a local variable.
 */
public final class TypedText {
  /** How much before the cursor is looked at; what is longer was not typed. */
  private static final int MOST = 1 << 14;

  private final String text;
  private final String open;
  private final List<Token> tokens = new ArrayList<>();

  /** The index of the token in which the cursor is; of the end when it is in none. */
  private final int last;

  private TypedText(String text) {
    this.text = text.substring(Math.max(0, text.length() - MOST));
    open = StatementSplitter.over(this.text).open();
    var lexer = new UrbiscriptLexer(new TextStream(this.text, 0, this.text.length()));
    Token token = lexer.nextToken();
    while (token.getType() != Token.EOF) {
      tokens.add(token);
      token = lexer.nextToken();
    }
    int end = tokens.size() - 1;
    last = end >= 0 && isWord(end) && ends(end) == this.text.length() ? end : tokens.size();
  }

  /** Looks at what has been typed; each {@code char} is a byte. */
  public static TypedText of(String text) {
    return new TypedText(text);
  }

  /** Whether no name can follow, because the cursor is in a string or a comment. */
  public boolean isInText() {
    return open.equals("\"") || open.startsWith("/");
  }

  /** The name that has been begun; empty when none has. */
  public String begun() {
    return text(last);
  }

  /** Whether a slot of {@link #receiver} follows, rather than the beginning of an expression. */
  public boolean isSlot() {
    return type(last - 1) == UrbiscriptLexer.DOT;
  }

  /** The expression before the dot; null when it is not a usual one. */
  public @Nullable String receiver() {
    int end = last - 2;
    int begin = end < 0 ? -1 : primary(end);
    return begin < 0 ? null : text.substring(begins(begin), ends(end));
  }

  /** The local variables and arguments that the cursor sees. */
  public Set<String> locals() {
    return declared().keySet();
  }

  /** The expression that a local variable was declared with; empty when there is none. */
  public String valueOf(String local) {
    return value(declared().getOrDefault(local, Integer.MAX_VALUE));
  }

  /** The local variables and arguments, with the tokens behind their names. */
  private Map<String, Integer> declared() {
    Deque<Map<String, Integer>> scopes = new ArrayDeque<>();
    scopes.push(new LinkedHashMap<>());
    // Arguments stand before the braces in which they are seen.
    Map<String, Integer> ahead = new LinkedHashMap<>();
    int parentheses = 0;
    int formals = -1;
    for (int i = 0; i < last; i++) {
      switch (type(i)) {
        case UrbiscriptLexer.LBRACE -> {
          scopes.push(ahead);
          ahead = new LinkedHashMap<>();
        }
        case UrbiscriptLexer.RBRACE -> {
          if (scopes.size() > 1) {
            scopes.pop();
          }
        }
        case UrbiscriptLexer.LPAREN -> parentheses++;
        case UrbiscriptLexer.RPAREN -> formals = --parentheses <= formals ? -1 : formals;
        case UrbiscriptLexer.SEMICOLON, UrbiscriptLexer.PIPE -> {
          if (parentheses == 0) {
            ahead.clear();
          }
        }
        case UrbiscriptLexer.FUNCTION, UrbiscriptLexer.CLOSURE -> formals = parentheses;
        case UrbiscriptLexer.VAR -> {
          if (isWord(i + 1) && type(i + 2) != UrbiscriptLexer.DOT) {
            (parentheses > 0 ? ahead : scopes.peek()).put(text(i + 1), i + 2);
          }
        }
        default -> {
          boolean argument =
              formals >= 0
                  && parentheses == formals + 1
                  && isWord(i)
                  && (type(i - 1) == UrbiscriptLexer.LPAREN
                      || type(i - 1) == UrbiscriptLexer.COMMA);
          if (argument) {
            ahead.put(text(i), i + 1);
          }
        }
      }
    }
    Map<String, Integer> seen = new LinkedHashMap<>();
    scopes.descendingIterator().forEachRemaining(seen::putAll);
    seen.putAll(ahead);
    return seen;
  }

  /** The expression behind {@code =}, up to what ends the declaration. */
  private String value(int assign) {
    if (type(assign) != UrbiscriptLexer.ASSIGN) {
      return "";
    }
    int depth = 0;
    int end = assign + 1;
    for (; end < last; end++) {
      switch (type(end)) {
        case UrbiscriptLexer.LPAREN, UrbiscriptLexer.LBRACKET, UrbiscriptLexer.LBRACE -> depth++;
        case UrbiscriptLexer.RPAREN, UrbiscriptLexer.RBRACKET, UrbiscriptLexer.RBRACE -> depth--;
        default -> {}
      }
      if (depth < 0 || depth == 0 && isSeparator(end)) {
        break;
      }
    }
    return end == assign + 1 ? "" : text.substring(begins(assign + 1), ends(end - 1));
  }

  private boolean isSeparator(int token) {
    int type = type(token);
    return type == UrbiscriptLexer.SEMICOLON
        || type == UrbiscriptLexer.PIPE
        || type == UrbiscriptLexer.COMMA
        || type == UrbiscriptLexer.AND;
  }

  /** The first token of {@code a.b(c)[d]}, the last token of which is given; -1 if it is none. */
  private int primary(int end) {
    int at = end;
    while (at >= 0) {
      int type = type(at);
      if (type == UrbiscriptLexer.RPAREN || type == UrbiscriptLexer.RBRACKET) {
        at = opener(at);
        boolean applied =
            isWord(at - 1)
                || type(at - 1) == UrbiscriptLexer.RPAREN
                || type(at - 1) == UrbiscriptLexer.RBRACKET;
        if (applied) {
          at--;
          continue;
        }
      } else if (!isWord(at)
          && type != UrbiscriptLexer.STRING
          && type != UrbiscriptLexer.NUMBER
          && type != UrbiscriptLexer.DURATION
          && type != UrbiscriptLexer.QUOTED) {
        return -1;
      }
      if (type(at - 1) != UrbiscriptLexer.DOT) {
        return at;
      }
      at -= 2;
    }
    return -1;
  }

  /** Where a bracket was opened that is closed there; -1 if nowhere. */
  private int opener(int closer) {
    int depth = 0;
    for (int i = closer; i >= 0; i--) {
      switch (type(i)) {
        case UrbiscriptLexer.RPAREN, UrbiscriptLexer.RBRACKET, UrbiscriptLexer.RBRACE -> depth++;
        case UrbiscriptLexer.LPAREN, UrbiscriptLexer.LBRACKET, UrbiscriptLexer.LBRACE -> depth--;
        default -> {}
      }
      if (depth == 0) {
        return i;
      }
    }
    return -1;
  }

  private boolean isWord(int token) {
    String word = text(token);
    return type(token) == UrbiscriptLexer.WORD
        || type(token) != UrbiscriptLexer.STRING && Keywords.all().contains(word);
  }

  private int type(int token) {
    return token < 0 || token >= tokens.size() ? Token.EOF : tokens.get(token).getType();
  }

  private String text(int token) {
    return type(token) == Token.EOF ? "" : tokens.get(token).getText();
  }

  private int begins(int token) {
    return tokens.get(token).getStartIndex();
  }

  private int ends(int token) {
    return tokens.get(token).getStopIndex() + 1;
  }
}

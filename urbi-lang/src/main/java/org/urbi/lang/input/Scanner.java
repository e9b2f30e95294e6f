package org.urbi.lang.input;

import java.util.Set;

/**
 * Finds where statements end, one character after the other: no character is looked at twice, and
 * it does not matter how the text was cut.
 */
final class Scanner {
  private static final Set<String> FLAVORED =
      Set.of("at", "every", "for", "foreach", "loop", "whenever", "while");
  private static final Set<String> HEADS = Set.of("for", "foreach", "if", "while");

  private static final String CLASS = "class";

  private enum State {
    CODE,
    SLASH,
    LINE_COMMENT,
    COMMENT,
    COMMENT_SLASH,
    COMMENT_STAR,
    STRING,
    STRING_ESCAPE,
    BLOB_OPEN,
    BLOB_SIZE,
    BLOB_CONTENTS,
    BLOB,
    QUOTED,
    QUOTED_ESCAPE
  }

  private State state = State.CODE;

  /** The open brackets; a parenthesis that may hold semicolons is an {@code f}. */
  private final StringBuilder brackets = new StringBuilder();

  private int comments;
  private long blob;
  private boolean digits;

  /** The last word, while nothing but blanks and a flavor followed it. */
  private final StringBuilder word = new StringBuilder();

  private boolean wordEnded;
  private boolean flavorTaken;

  /** Whether an apostrophe here would be a derivative's, not a quote. */
  private boolean afterName;

  /** In the head of a class outside brackets; its prototypes are separated by commas. */
  private boolean classHead;

  private boolean prototypes;
  private boolean blank = true;

  /** Whether nothing but blanks and comments was seen since the last end. */
  boolean isBlank() {
    return blank;
  }

  /** Whether the text is in the middle of a string, a comment or a quoted name. */
  boolean inCode() {
    return state == State.CODE || state == State.LINE_COMMENT || state == State.SLASH;
  }

  /** Takes a character; true if a statement ends with it. */
  boolean take(char c) {
    switch (state) {
      case CODE -> {
        return code(c);
      }
      case SLASH -> {
        if (c == '/') {
          state = State.LINE_COMMENT;
        } else if (c == '*') {
          state = State.COMMENT;
          comments = 1;
        } else {
          state = State.CODE;
          blank = false;
          forget();
          return code(c);
        }
      }
      case LINE_COMMENT -> {
        if (c == '\n') {
          state = State.CODE;
          afterName = false;
        }
      }
      case COMMENT -> inComment(c);
      case COMMENT_SLASH -> {
        state = State.COMMENT;
        if (c == '*') {
          comments++;
        } else {
          inComment(c);
        }
      }
      case COMMENT_STAR -> {
        state = State.COMMENT;
        if (c == '/') {
          comments--;
          state = comments == 0 ? State.CODE : State.COMMENT;
        } else {
          inComment(c);
        }
      }
      case STRING -> inString(c);
      case STRING_ESCAPE -> state = c == 'B' ? State.BLOB_OPEN : State.STRING;
      case BLOB_OPEN -> {
        blob = 0;
        digits = false;
        next(c == '(', State.BLOB_SIZE, c);
      }
      case BLOB_SIZE -> {
        if (c >= '0' && c <= '9') {
          digits = true;
          blob = Math.min(blob * 10 + c - '0', Integer.MAX_VALUE);
        } else {
          next(c == ')' && digits, State.BLOB_CONTENTS, c);
        }
      }
      case BLOB_CONTENTS -> next(c == '(', blob == 0 ? State.STRING : State.BLOB, c);
      case BLOB -> {
        blob--;
        state = blob == 0 ? State.STRING : State.BLOB;
      }
      case QUOTED -> {
        if (c == '\\') {
          state = State.QUOTED_ESCAPE;
        } else if (c == '\'') {
          state = State.CODE;
        }
      }
      case QUOTED_ESCAPE -> state = State.QUOTED;
    }
    return false;
  }

  private void next(boolean expected, State then, char c) {
    if (expected) {
      state = then;
    } else {
      state = State.STRING;
      inString(c);
    }
  }

  private void inString(char c) {
    if (c == '\\') {
      state = State.STRING_ESCAPE;
    } else if (c == '"') {
      state = State.CODE;
    }
  }

  private void inComment(char c) {
    if (c == '/') {
      state = State.COMMENT_SLASH;
    } else if (c == '*') {
      state = State.COMMENT_STAR;
    }
  }

  private boolean code(char c) {
    if (c == '/') {
      state = State.SLASH;
      afterName = false;
      wordEnded = true;
      return false;
    } else if (c == ' ' || c >= '\t' && c <= '\r') {
      afterName = false;
      wordEnded = true;
      return false;
    }
    blank = false;
    if (isWord(c)) {
      if (wordEnded || flavorTaken) {
        followClass(c);
        forget();
      }
      // No keyword is that long.
      if (word.length() < 32) {
        word.append(c);
      }
      afterName = true;
      return false;
    } else if (c == ';' || c == ',' || c == '|' || c == '&') {
      return separator(c);
    }
    followClass(c);
    boolean head = c == '(' && HEADS.contains(word.toString());
    forget();
    switch (c) {
      case '"' -> state = State.STRING;
      case '\'' -> {
        if (!afterName) {
          state = State.QUOTED;
        }
        return false;
      }
      case '(' -> brackets.append(head ? 'f' : '(');
      case '[', '{' -> brackets.append(c);
      case ')', ']', '}' -> close(c);
      default -> {}
    }
    afterName = false;
    return false;
  }

  private boolean separator(char c) {
    afterName = false;
    if (!flavorTaken && FLAVORED.contains(word.toString())) {
      flavorTaken = true;
      return false;
    }
    followClass(c);
    forget();
    char open = brackets.isEmpty() ? '\0' : brackets.charAt(brackets.length() - 1);
    boolean ends =
        switch (c) {
          case ';' -> open != '{' && open != 'f';
          case ',' -> open == '\0' && !prototypes;
          default -> false;
        };
    if (ends) {
      brackets.setLength(0);
      classHead = false;
      blank = true;
    }
    return ends;
  }

  private void close(char c) {
    int at = brackets.length() - 1;
    while (at >= 0 && !matches(brackets.charAt(at), c)) {
      at--;
    }
    if (at >= 0) {
      brackets.setLength(at);
    }
  }

  private static boolean matches(char open, char close) {
    return switch (close) {
      case ')' -> open == '(' || open == 'f';
      case ']' -> open == '[';
      default -> open == '{';
    };
  }

  /** Follows the head of a class, when a word has ended with something else than a blank. */
  private void followClass(char c) {
    if (brackets.isEmpty() && CLASS.contentEquals(word)) {
      classHead = true;
    }
    if (c == ':' && classHead) {
      prototypes = true;
    } else if (c == '{' || c == ';') {
      classHead = false;
      prototypes = false;
    }
  }

  private void forget() {
    word.setLength(0);
    wordEnded = false;
    flavorTaken = false;
  }

  private static boolean isWord(char c) {
    return c >= 'a' && c <= 'z'
        || c >= 'A' && c <= 'Z'
        || c >= '0' && c <= '9'
        || c == '_'
        || c == '$';
  }
}

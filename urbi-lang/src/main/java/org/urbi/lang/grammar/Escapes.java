package org.urbi.lang.grammar;

import org.urbi.lang.problem.SyntaxProblem;

/**
 * Reads what follows an opening quote, up to the closing one, and resolves escapes (manual,
 * "Strings").
 */
final class Escapes {
  /** Is told what is wrong. */
  interface Listener {
    /**
     * A wrong escape.
     *
     * @param end the offset after it
     */
    void wrong(int end, SyntaxProblem problem, Object... values);
  }

  private final String text;
  private final int end;
  private final char quote;
  private final Listener listener;
  private final StringBuilder value = new StringBuilder();
  private int at;

  /**
   * @param at the offset after the opening quote
   * @param end where the text ends
   * @param quote the closing quote
   * @param listener is told of wrong escapes
   */
  Escapes(String text, int at, int end, char quote, Listener listener) {
    this.text = text;
    this.at = at;
    this.end = end;
    this.quote = quote;
    this.listener = listener;
  }

  /** Reads up to the closing quote; false when there is none. */
  boolean read() {
    while (at < end) {
      int run = at;
      while (at < end && text.charAt(at) != quote && text.charAt(at) != '\\') {
        at++;
      }
      value.append(text, run, at);
      if (at < end) {
        if (text.charAt(at++) == quote) {
          return true;
        }
        if (at < end) {
          escape(text.charAt(at++));
        }
      }
    }
    return false;
  }

  /** The offset after what was read. */
  int position() {
    return at;
  }

  String value() {
    return value.toString();
  }

  private void escape(char c) {
    switch (c) {
      case '\\', '"', '\'' -> value.append(c);
      case 'a' -> value.append('\007');
      case 'b' -> value.append('\b');
      case 'f' -> value.append('\f');
      case 'n' -> value.append('\n');
      case 'r' -> value.append('\r');
      case 't' -> value.append('\t');
      case 'v' -> value.append('\013');
      case 'x' -> hexadecimal();
      case 'B' -> blob();
      default -> {
        if ('0' <= c && c <= '7') {
          octal();
        } else {
          listener.wrong(at, SyntaxProblem.ESCAPED_CHARACTER, CharacterDisplay.show(c));
        }
      }
    }
  }

  private void octal() {
    int first = at - 1;
    while (at < end && at - first < 3 && '0' <= text.charAt(at) && text.charAt(at) <= '7') {
      at++;
    }
    int code = Integer.parseInt(text, first, at, 8);
    if (code > 255) {
      listener.wrong(at, SyntaxProblem.ESCAPED_NUMBER, text.substring(first, at));
    } else {
      value.append((char) code);
    }
  }

  private void hexadecimal() {
    int first = at;
    while (at < end && at - first < 2 && Character.digit(text.charAt(at), 16) >= 0) {
      at++;
    }
    if (at - first < 2) {
      listener.wrong(at, SyntaxProblem.ESCAPED_CHARACTER, "x");
    } else {
      value.append((char) Integer.parseInt(text, first, at, 16));
    }
  }

  /** {@code \B(size)(contents)}: the contents are taken as they are. */
  private void blob() {
    int escape = at - 2;
    int size = 0;
    if (!blobCharacter(escape, '(')) {
      return;
    }
    int digits = at;
    while (at < end && Character.digit(text.charAt(at), 10) >= 0 && at - digits < 10) {
      size = (int) Math.min(Integer.MAX_VALUE, size * 10L + text.charAt(at++) - '0');
    }
    if (at == digits) {
      blobError(escape);
      return;
    }
    if (!blobCharacter(escape, ')') || !blobCharacter(escape, '(')) {
      return;
    }
    int contents = at;
    at = (int) Math.min(end, (long) at + size);
    value.append(text, contents, at);
    if (at < end && text.charAt(at) != ')') {
      listener.wrong(at, SyntaxProblem.OPEN_BLOB, CharacterDisplay.show(text.charAt(at)));
    }
    at = Math.min(end, at + 1);
  }

  private boolean blobCharacter(int escape, char expected) {
    if (at < end && text.charAt(at) == expected) {
      at++;
      return true;
    }
    blobError(escape);
    return false;
  }

  private void blobError(int escape) {
    // The character that does not fit is part of the error, but never the closing quote.
    if (at < end && text.charAt(at) != quote) {
      at++;
    }
    listener.wrong(at, SyntaxProblem.ESCAPED_BLOB, text.substring(escape, at));
  }
}

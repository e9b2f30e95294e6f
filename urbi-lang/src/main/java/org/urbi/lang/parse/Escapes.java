package org.urbi.lang.parse;

import org.urbi.lang.source.Span;

/** The escapes of strings and of quoted identifiers. */
final class Escapes {
  private final String text;
  private final Span span;
  private final Errors errors;
  private final StringBuilder value = new StringBuilder();
  private int at = 1;

  private Escapes(String text, Span span, Errors errors) {
    this.text = text;
    this.span = span;
    this.errors = errors;
  }

  /** Reports what is wrong in a literal. */
  static void check(String text, Span span, Errors errors) {
    if (text.indexOf('\\') >= 0) {
      new Escapes(text, span, errors).read();
    }
  }

  /** The value of a literal that is known to be right. */
  static String value(String text) {
    if (text.indexOf('\\') < 0) {
      return text.substring(1, text.length() - 1);
    }
    return new Escapes(text, null, null).read();
  }

  private String read() {
    int end = text.length() - 1;
    while (at < end) {
      char c = text.charAt(at++);
      if (c == '\\') {
        escape(text.charAt(at++));
      } else {
        value.append(c);
      }
    }
    return value.toString();
  }

  private void escape(char c) {
    int simple = "abfnrtv\\\"'`".indexOf(c);
    if (simple >= 0) {
      value.append("\u0007\b\f\n\r\t\u000B\\\"'`".charAt(simple));
    } else if (c >= '0' && c <= '7') {
      at--;
      number(8, 3, at);
    } else if (c == 'x' && Character.digit(peek(), 16) >= 0) {
      number(16, 2, at);
    } else if (c == 'B') {
      blob();
    } else if (c != '\n') {
      error("invalid character after \\-escape: `" + c + "'");
    }
  }

  private void number(int radix, int digits, int begin) {
    int number = 0;
    while (at < begin + digits && Character.digit(peek(), radix) >= 0) {
      number = number * radix + Character.digit(peek(), radix);
      at++;
    }
    if (number > 255) {
      error("invalid number after \\-escape: `" + text.substring(begin, at) + "'");
    } else {
      value.append((char) number);
    }
  }

  private void blob() {
    int begin = at - 2;
    long size = 0;
    boolean good = take('(') && Character.digit(peek(), 10) >= 0;
    while (good && Character.digit(peek(), 10) >= 0) {
      size = Math.min(size * 10 + Character.digit(peek(), 10), Integer.MAX_VALUE);
      at++;
    }
    if (!good || !take(')') || !take('(')) {
      at = Math.min(at + 1, text.length() - 1);
      error("invalid \\B(SIZE)(CONTENTS) escape: `" + text.substring(begin, at) + "'");
      return;
    }
    int end = (int) Math.min(at + size, text.length() - 1);
    value.append(text, at, end);
    at = end;
    if (!take(')')) {
      error("unexpected '" + peek() + "' for closing \\B, expected ')'");
    }
  }

  private boolean take(char c) {
    if (at < text.length() && text.charAt(at) == c) {
      at++;
      return true;
    }
    return false;
  }

  private char peek() {
    return at < text.length() ? text.charAt(at) : '\0';
  }

  private void error(String message) {
    if (errors != null) {
      errors.add(errors.span(span.begin(), span.begin() + at), message);
    }
  }
}

package org.urbi.lang.print;

/** Strings as they are written in a program. */
public final class StringEscape {
  private static final String SPECIAL = "\u0007\b\f\n\r\t\u000B\\";
  private static final String LETTERS = "abfnrtv\\";

  private StringEscape() {}

  /** The contents of a literal between double quotes. */
  public static String escape(String value) {
    return escape(value, '"');
  }

  /** The literal, double quotes included. */
  public static String quote(String value) {
    return '"' + escape(value) + '"';
  }

  static String escape(String value, char quote) {
    var text = new StringBuilder(value.length());
    for (int i = 0; i < value.length(); i++) {
      char c = value.charAt(i);
      int special = SPECIAL.indexOf(c);
      if (special >= 0) {
        text.append('\\').append(LETTERS.charAt(special));
      } else if (c == quote) {
        text.append('\\').append(c);
      } else if (c >= ' ' && c < 127) {
        text.append(c);
      } else {
        text.append(String.format("\\x%02x", (int) c));
      }
    }
    return text.toString();
  }
}

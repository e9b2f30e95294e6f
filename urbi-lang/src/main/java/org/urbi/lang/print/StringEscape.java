package org.urbi.lang.print;

import org.urbi.lang.grammar.Keywords;

/** Writes strings and names so that they can be read again (manual, "Strings"). */
public final class StringEscape {
  private static final String HEXADECIMAL = "0123456789abcdef";

  private StringEscape() {}

  /** The string as a literal: between double quotes. */
  public static String quote(String text) {
    return '"' + escape(text, '"') + '"';
  }

  /** The contents of a literal between quotes of a kind. */
  public static String escape(String text, char quote) {
    var escaped = new StringBuilder(text.length() + 8);
    append(escaped, text, 0, text.length(), quote);
    return escaped.toString();
  }

  /** Appends a part of the contents of such a literal, from an index to another one. */
  public static void append(StringBuilder escaped, String text, int begin, int end, char quote) {
    for (int i = begin; i < end; i++) {
      append(escaped, text.charAt(i), quote);
    }
  }

  /** The name as an identifier: between simple quotes unless it may go without. */
  public static String name(String name) {
    return plain(name) ? name : '\'' + escape(name, '\'') + '\'';
  }

  private static void append(StringBuilder escaped, char c, char quote) {
    switch (c) {
      case '\007' -> escaped.append("\\a");
      case '\b' -> escaped.append("\\b");
      case '\f' -> escaped.append("\\f");
      case '\013' -> escaped.append("\\v");
      default -> appendBasic(escaped, c, quote);
    }
  }

  /**
   * Appends a byte with only those escapes that clients of Urbi 2.7 read, too: line ends, tabs,
   * backslashes, quotes of that kind, and hexadecimal numbers for all that is not printable ASCII.
   */
  public static void appendBasic(StringBuilder escaped, char c, char quote) {
    switch (c) {
      case '\n' -> escaped.append("\\n");
      case '\r' -> escaped.append("\\r");
      case '\t' -> escaped.append("\\t");
      case '\\' -> escaped.append("\\\\");
      default -> {
        if (c == quote) {
          escaped.append('\\').append(c);
        } else if (' ' <= c && c < 127) {
          escaped.append(c);
        } else {
          escaped.append("\\x");
          escaped.append(HEXADECIMAL.charAt(c >> 4 & 15)).append(HEXADECIMAL.charAt(c & 15));
        }
      }
    }
  }

  private static boolean plain(String name) {
    if (name.isEmpty() || Keywords.keyword(name) || name.equals("self")) {
      return false;
    }
    for (int i = 0; i < name.length(); i++) {
      char c = name.charAt(i);
      boolean letter = 'a' <= c && c <= 'z' || 'A' <= c && c <= 'Z' || c == '_';
      if (!letter && (i == 0 || c < '0' || '9' < c)) {
        return false;
      }
    }
    return true;
  }
}

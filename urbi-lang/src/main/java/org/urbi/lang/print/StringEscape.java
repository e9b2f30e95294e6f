package org.urbi.lang.print;

import org.urbi.lang.grammar.Keywords;

/** Writes strings and names so that they can be read again (manual, "Strings"). */
public final class StringEscape {
  private static final String HEXADECIMAL = "0123456789abcdef";

  private StringEscape() {}

  /** The string as a literal: between double quotes. */
  public static String quote(String text) {
    var quoted = new StringBuilder(text.length() + 8);
    appendQuoted(quoted, text);
    return quoted.toString();
  }

  /** Appends the string as a literal: between double quotes. */
  static void appendQuoted(StringBuilder to, String text) {
    to.append('"');
    append(to, text, 0, text.length(), '"');
    to.append('"');
  }

  /** The contents of a literal between quotes of a kind. */
  public static String escape(String text, char quote) {
    var escaped = new StringBuilder(text.length() + 8);
    append(escaped, text, 0, text.length(), quote);
    return escaped.toString();
  }

  /** Appends a part of the contents of such a literal, from an index to another one. */
  public static void append(StringBuilder escaped, String text, int begin, int end, char quote) {
    int written = begin;
    for (int i = begin; i < end; i++) {
      char c = text.charAt(i);
      if (c < ' ' || 127 <= c || c == quote || c == '\\') {
        // What stands between two of these is appended at once.
        escaped.append(text, written, i);
        append(escaped, c, quote);
        written = i + 1;
      }
    }
    escaped.append(text, written, end);
  }

  /** The name as an identifier: between simple quotes unless it may go without. */
  public static String name(String name) {
    return plain(name) ? name : '\'' + escape(name, '\'') + '\'';
  }

  /** Appends the name as an identifier. */
  static void appendName(StringBuilder to, String name) {
    if (plain(name)) {
      to.append(name);
    } else {
      to.append('\'');
      append(to, name, 0, name.length(), '\'');
      to.append('\'');
    }
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
    boolean lower = !name.isEmpty();
    for (int i = 0; i < name.length(); i++) {
      char c = name.charAt(i);
      if (i == 0 ? !Keywords.startsWord(c) : !Keywords.isInWord(c)) {
        return false;
      }
      lower &= '_' <= c;
    }
    // Keywords are lower-case: to look up only what may be one makes a long text cheaper.
    return lower ? !Keywords.keyword(name) && !name.equals("self") : !name.isEmpty();
  }
}

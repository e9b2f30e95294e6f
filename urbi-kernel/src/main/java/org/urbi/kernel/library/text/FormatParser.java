package org.urbi.kernel.library.text;

/** Reads formats like those of {@code printf} (manual, "FormatInfo"). */
final class FormatParser {
  /** A format that cannot be read; the message is for the user. */
  static final class Malformed extends Exception {
    Malformed(String message) {
      super(message, null, false, false);
    }
  }

  private static final String CONVERSIONS = "sdxoef";

  private final String text;
  private int at;

  /** The format starts at the {@code %} that stands at an index. */
  FormatParser(String text, int start) {
    this.text = text;
    this.at = start;
  }

  /** Where the format that has been read ends. */
  int end() {
    return at;
  }

  private boolean next(char c) {
    if (at < text.length() && text.charAt(at) == c) {
      at++;
      return true;
    }
    return false;
  }

  /** Reads one format. */
  UrbiFormatInfo.Format parse() throws Malformed {
    int start = at;
    if (!next('%')) {
      throw new Malformed("format does not begin with `%': " + text);
    }
    boolean piped = next('|');
    int alignment = 1;
    boolean alternate = false;
    String group = "";
    char pad = ' ';
    String prefix = "";
    boolean more = true;
    while (more) {
      char option = at < text.length() ? text.charAt(at) : 0;
      switch (option) {
        case '-' -> alignment = -1;
        case '=' -> alignment = 0;
        case '+' -> prefix = "+";
        case ' ' -> prefix = " ";
        case '0' -> pad = '0';
        case '#' -> alternate = true;
        case '\'' -> group = " ";
        default -> more = false;
      }
      at += more ? 1 : 0;
    }
    final int width = number();
    int precision = -1;
    if (next('.')) {
      precision = Math.max(0, number());
    }
    char conversion = 's';
    if (!piped || at < text.length() && text.charAt(at) != '|') {
      if (at >= text.length()) {
        throw new Malformed("format without conversion: " + text.substring(start));
      }
      conversion = text.charAt(at++);
    }
    char spec = Character.toLowerCase(conversion);
    if (CONVERSIONS.indexOf(spec) < 0) {
      throw new Malformed(
          "format: \"" + conversion + "\" is not a valid conversion type character");
    }
    if (piped && !next('|')) {
      throw new Malformed("format without final `|': " + text.substring(start));
    }
    int uppercase = conversion == 's' ? 0 : Character.isUpperCase(conversion) ? 1 : -1;
    return new UrbiFormatInfo.Format(
        text.substring(start, at),
        alignment,
        alternate,
        group,
        pad,
        prefix,
        Math.max(0, width),
        precision,
        spec,
        uppercase);
  }

  /** A number; -1 without digits. */
  private int number() throws Malformed {
    int start = at;
    while (at < text.length() && text.charAt(at) >= '0' && text.charAt(at) <= '9') {
      at++;
    }
    if (at - start > 6) {
      throw new Malformed("number too large: " + text.substring(start, at));
    }
    return at == start ? -1 : Integer.parseInt(text, start, at, 10);
  }
}

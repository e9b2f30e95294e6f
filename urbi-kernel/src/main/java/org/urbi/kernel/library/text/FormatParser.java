package org.urbi.kernel.library.text;

import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;

/** Reads formats like those of {@code printf} (manual, "FormatInfo"). */
final class FormatParser {
  /** A format that cannot be read. */
  static final class Malformed extends Exception {
    private final Problem problem;
    private final transient Object[] places;

    Malformed(Problem problem, Object... places) {
      super(null, null, false, false);
      this.problem = problem;
      this.places = places;
    }

    /** The exception for it, thrown by the function called at that site. */
    UrbiException thrownBy(Frame caller, CallSite site) {
      return caller.error(site, problem, places);
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
      throw new Malformed(Problem.FORMAT_WITHOUT_PERCENT, text);
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
        throw new Malformed(Problem.FORMAT_WITHOUT_CONVERSION, text.substring(start));
      }
      conversion = text.charAt(at++);
    }
    char spec = Character.toLowerCase(conversion);
    if (CONVERSIONS.indexOf(spec) < 0) {
      throw new Malformed(Problem.FORMAT_CONVERSION, conversion);
    }
    if (piped && !next('|')) {
      throw new Malformed(Problem.FORMAT_WITHOUT_END, text.substring(start));
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
      throw new Malformed(Problem.FORMAT_NUMBER, text.substring(start, at));
    }
    return at == start ? -1 : Integer.parseInt(text, start, at, 10);
  }
}

package org.urbi.lang.grammar;

import java.util.HexFormat;

/** The value of a number as written (manual, "Floats", "Angles" and "Durations"). */
final class Numbers {
  /**
   * @param value radians for an angle, seconds for a duration; NaN when the text is no number
   * @param duration whether there is a time unit
   */
  record Value(double value, boolean duration) {}

  static final Value INVALID = new Value(Double.NaN, false);

  private Numbers() {}

  static Value parse(String text) {
    if (text.length() > 1 && text.charAt(0) == '0' && (text.charAt(1) | 0x20) == 'x') {
      return hexadecimal(text);
    }
    int unit = unitOf(text);
    String digits = text.substring(0, unit);
    if (digits.indexOf('_') >= 0) {
      if (digits.endsWith("_")) {
        return INVALID;
      }
      digits = digits.replace("_", "");
    }
    double value = Double.parseDouble(digits);
    return switch (text.substring(unit)) {
      case "", "rad" -> new Value(value, false);
      case "deg" -> new Value(value / 180 * Math.PI, false);
      case "grad" -> new Value(value / 200 * Math.PI, false);
      case "ms" -> new Value(value / 1000, true);
      case "s" -> new Value(value, true);
      case "min", "m" -> new Value(value * 60, true);
      case "h" -> new Value(value * 3600, true);
      case "d" -> new Value(value * 86400, true);
      default -> INVALID;
    };
  }

  private static Value hexadecimal(String text) {
    String digits = text.substring(2).replace("_", "");
    if (digits.isEmpty() || !digits.chars().allMatch(HexFormat::isHexDigit)) {
      return INVALID;
    }
    // Unlike BigInteger, which takes the square of their number in time.
    return new Value(Double.parseDouble("0x" + digits + "p0"), false);
  }

  /** Where the unit starts: after the digits and the exponent. */
  private static int unitOf(String text) {
    int at = digits(text, 0);
    if (at < text.length() && text.charAt(at) == '.') {
      at = digits(text, at + 1);
    }
    if (at < text.length() && (text.charAt(at) | 0x20) == 'e') {
      int exponent = at + 1;
      if (exponent < text.length() && "+-".indexOf(text.charAt(exponent)) >= 0) {
        exponent++;
      }
      int last = digits(text, exponent);
      if (last > exponent) {
        return last;
      }
    }
    return at;
  }

  private static int digits(String text, int from) {
    int at = from;
    while (at < text.length()
        && (Character.digit(text.charAt(at), 10) >= 0 || at > from && text.charAt(at) == '_')) {
      at++;
    }
    return at;
  }
}

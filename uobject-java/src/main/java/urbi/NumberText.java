package urbi;

import java.math.BigInteger;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Numbers, angles and durations as urbiscript writes them. */
final class NumberText {
  private static final Pattern PART =
      Pattern.compile(
          "((?:[0-9](?:_*[0-9])*(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][-+]?[0-9]+)?)([a-z_]*)");

  private static final Pattern DECIMAL =
      Pattern.compile("[0-9]+(?:\\.[0-9]*)?(?:[eE][-+]?[0-9]+)?");

  private NumberText() {}

  /** The number: radians of an angle, seconds of a duration; NaN when it is none. */
  static double parse(String text) {
    if (DECIMAL.matcher(text).matches()) {
      return Double.parseDouble(text);
    }
    if (text.equals("inf")) {
      return Double.POSITIVE_INFINITY;
    }
    if (text.matches("0[xX][0-9a-fA-F_]+")) {
      return new BigInteger(text.substring(2).replace("_", ""), 16).doubleValue();
    }
    Matcher part = PART.matcher(text);
    double sum = 0;
    int at = 0;
    boolean duration = false;
    while (part.find() && part.start() == at) {
      if (at > 0 && !duration) {
        return Double.NaN;
      }
      double value = Double.parseDouble(part.group(1).replace("_", ""));
      duration = part.group(2).matches("ms|s|min|m|h|d");
      sum += value(value, part.group(2));
      at = part.end();
      if (at == text.length()) {
        return sum;
      }
    }
    return Double.NaN;
  }

  private static double value(double value, String unit) {
    return switch (unit) {
      case "", "rad" -> value;
      case "deg" -> value / 180 * Math.PI;
      case "grad" -> value / 200 * Math.PI;
      case "ms" -> value / 1000;
      case "s" -> value;
      case "min", "m" -> value * 60;
      case "h" -> value * 3600;
      case "d" -> value * 86400;
      default -> Double.NaN;
    };
  }
}

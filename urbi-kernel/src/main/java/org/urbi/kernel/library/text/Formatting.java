package org.urbi.kernel.library.text;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.print.FloatFormat;

/** Values as formats want them (manual, "FormatInfo", "Float.format"). */
public final class Formatting {
  private static final double[] POWERS_OF_TEN = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

  /** Below it, halves of integers are numbers, too. */
  private static final double EXACT = 1L << 51;

  /** Behind the point, and in all, a number has fewer digits: others are zeros. */
  private static final int MOST_DIGITS = 1100;

  private Formatting() {}

  /** Any value. */
  public static String format(Frame caller, String routine, UrbiObject value, UrbiFormatInfo info) {
    if (value instanceof UrbiFloat number) {
      return formatNumber(caller, routine, number, info.format());
    }
    UrbiFormatInfo.Format format = info.format();
    String text = caller.interpreter().asString(caller, value);
    if (format.precision() >= 0 && format.precision() < text.length()) {
      text = text.substring(0, format.precision());
    }
    if (format.prefix().equals(" ") && !text.startsWith("+") && !text.startsWith("-")) {
      text = " " + text;
    }
    return pad(inCase(caller, text, format), 0, format);
  }

  /** An integer in hexadecimal. */
  public static String hexadecimal(Frame caller, String routine, UrbiFloat number) {
    return Long.toHexString(integer(caller, routine, number));
  }

  private static long integer(Frame caller, String routine, UrbiFloat number) {
    long integer = (long) number.value();
    if (integer != number.value()) {
      throw notInteger(caller, routine, number);
    }
    return integer;
  }

  private static UrbiException notInteger(Frame caller, String routine, UrbiFloat number) {
    return caller.interpreter().errors().badNumber(routine, Problem.NOT_INTEGER, number);
  }

  private static String formatNumber(
      Frame caller, String routine, UrbiFloat number, UrbiFormatInfo.Format format) {
    double value = number.value();
    String digits =
        switch (format.spec()) {
          case 'x' -> radix(integer(caller, routine, number), 16, "0x", format);
          case 'o' -> radix(integer(caller, routine, number), 8, "0", format);
          default -> Double.isFinite(value) ? decimal(value, format) : FloatFormat.format(value);
        };
    if (!digits.startsWith("-")) {
      digits = format.prefix() + digits;
    }
    int sign = digits.startsWith("-") || digits.startsWith("+") || digits.startsWith(" ") ? 1 : 0;
    if (format.alternate() && format.spec() == 'x') {
      sign += 2;
    }
    return pad(inCase(caller, digits, format), Double.isFinite(value) ? sign : 0, format);
  }

  private static String radix(long value, int radix, String base, UrbiFormatInfo.Format format) {
    String digits = Long.toString(Math.abs(value), radix);
    return (value < 0 ? "-" : "")
        + (format.alternate() ? base : "")
        + grouped(digits, format.group());
  }

  private static String decimal(double value, UrbiFormatInfo.Format format) {
    int precision = format.precisionOrDefault();
    boolean negative = value < 0 || 1 / value < 0;
    double size = Math.abs(value);
    String digits =
        switch (format.spec()) {
          case 'f' -> fixed(size, precision);
          case 'e' -> scientific(new BigDecimal(size), precision);
          default -> shortest(size, format);
        };
    if (format.alternate() && digits.indexOf('.') < 0) {
      int end = digits.indexOf('e') < 0 ? digits.length() : digits.indexOf('e');
      digits = digits.substring(0, end) + "." + digits.substring(end);
    }
    return (negative ? "-" : "") + groupedInteger(digits, format.group());
  }

  /** With so many decimals: of the two nearest such numbers the even one. */
  static String fixed(double size, int precision) {
    if (precision < POWERS_OF_TEN.length && size * POWERS_OF_TEN[precision] < EXACT) {
      return fixedByLong(size, precision);
    }
    int known = Math.min(precision, MOST_DIGITS);
    return new BigDecimal(size).setScale(known, RoundingMode.HALF_EVEN).toPlainString()
        + "0".repeat(precision - known);
  }

  /**
   * A number that fits into a long with so many decimals. The product is the sum of its rounded
   * value and the error of that, both of which are known exactly; the error is smaller than what
   * the rounded value can be away from a half without being one.
   */
  private static String fixedByLong(double size, int precision) {
    double power = POWERS_OF_TEN[precision];
    double product = size * power;
    double error = Math.fma(size, power, -product);
    long units = (long) product;
    double fromHalf = product - units - 0.5;
    boolean up = fromHalf != 0 ? fromHalf > 0 : error != 0 ? error > 0 : (units & 1) != 0;
    String digits = Long.toString(up ? units + 1 : units);
    if (precision == 0) {
      return digits;
    }
    String padded = "0".repeat(Math.max(0, precision + 1 - digits.length())) + digits;
    int point = padded.length() - precision;
    return padded.substring(0, point) + "." + padded.substring(point);
  }

  private static String scientific(BigDecimal size, int precision) {
    int exponent = 0;
    int known = Math.min(precision, MOST_DIGITS);
    BigDecimal rounded = size;
    if (size.signum() != 0) {
      rounded = size.round(new MathContext(known + 1, RoundingMode.HALF_EVEN));
      exponent = rounded.precision() - rounded.scale() - 1;
    }
    String mantissa =
        rounded.movePointLeft(exponent).setScale(known, RoundingMode.HALF_EVEN).toPlainString();
    return mantissa + "0".repeat(precision - known) + exponent(exponent);
  }

  private static String exponent(int exponent) {
    int size = Math.abs(exponent);
    return (exponent < 0 ? "e-" : "e+") + (size < 10 ? "0" : "") + size;
  }

  /** As {@code %g} of C; integers keep all their digits when no precision is asked for. */
  private static String shortest(double exact, UrbiFormatInfo.Format format) {
    if (format.precision() < 0 && exact < EXACT && exact == (long) exact) {
      return Long.toString((long) exact);
    }
    if (exact == 0) {
      return "0";
    }
    BigDecimal size = new BigDecimal(exact);
    if (format.precision() < 0
        && size.stripTrailingZeros().scale() <= 0
        && size.precision() - size.scale() <= 19) {
      return size.toBigInteger().toString();
    }
    int precision = Math.max(1, format.precisionOrDefault());
    BigDecimal rounded = size.round(new MathContext(precision, RoundingMode.HALF_EVEN));
    int exponent = rounded.precision() - rounded.scale() - 1;
    if (exponent < -4 || exponent >= precision) {
      return rounded.movePointLeft(exponent).stripTrailingZeros().toPlainString()
          + exponent(exponent);
    }
    return rounded.stripTrailingZeros().toPlainString();
  }

  private static String groupedInteger(String digits, String group) {
    int end = 0;
    while (end < digits.length() && Character.isDigit(digits.charAt(end))) {
      end++;
    }
    return grouped(digits.substring(0, end), group) + digits.substring(end);
  }

  private static String grouped(String digits, String group) {
    if (group.isEmpty()) {
      return digits;
    }
    StringBuilder out = new StringBuilder(digits);
    for (int i = digits.length() - 3; i > 0; i -= 3) {
      out.insert(i, group);
    }
    return out.toString();
  }

  private static String inCase(Frame caller, String text, UrbiFormatInfo.Format format) {
    return switch (format.uppercase()) {
      case 1 -> Characters.upper(caller.job(), text);
      case -1 -> Characters.lower(caller.job(), text);
      default -> text;
    };
  }

  /**
   * Pads to the width.
   *
   * @param head how many characters come before padding by zeros
   */
  private static String pad(String text, int head, UrbiFormatInfo.Format format) {
    int missing = format.width() - text.length();
    if (missing <= 0) {
      return text;
    }
    String padding = String.valueOf(format.pad()).repeat(missing);
    return switch (format.alignment()) {
      case -1 -> text + " ".repeat(missing);
      case 0 -> " ".repeat(missing / 2) + text + " ".repeat(missing - missing / 2);
      default ->
          format.pad() == '0'
              ? text.substring(0, head) + padding + text.substring(head)
              : padding + text;
    };
  }
}

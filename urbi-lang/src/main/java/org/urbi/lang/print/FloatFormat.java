package org.urbi.lang.print;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * Shows numbers with six significant digits, as C's {@code %g}, but all the digits of integers up
 * to 2<sup>63</sup> (manual, "Floats", "Float.asString").
 */
public final class FloatFormat {
  private static final int DIGITS = 6;
  private static final MathContext ROUNDING = new MathContext(DIGITS, RoundingMode.HALF_EVEN);

  private FloatFormat() {}

  /** {@code 42}, {@code 0.5}, {@code 1e-06}, {@code 1e+20}, {@code inf}, {@code nan}. */
  public static String format(double value) {
    if (Double.isNaN(value)) {
      return "nan";
    }
    if (Double.isInfinite(value)) {
      return value > 0 ? "inf" : "-inf";
    }
    if (value == (long) value && Math.abs(value) < 0x1p63 && (value != 0 || 1 / value > 0)) {
      return Long.toString((long) value);
    }
    if (value == 0) {
      return "-0";
    }
    BigDecimal rounded = new BigDecimal(value).round(ROUNDING).stripTrailingZeros();
    int exponent = rounded.precision() - rounded.scale() - 1;
    if (-4 <= exponent && exponent < DIGITS) {
      return rounded.toPlainString();
    }
    String digits = rounded.unscaledValue().abs().toString();
    var text = new StringBuilder();
    text.append(value < 0 ? "-" : "").append(digits.charAt(0));
    if (digits.length() > 1) {
      text.append('.').append(digits, 1, digits.length());
    }
    text.append(exponent < 0 ? "e-" : "e+");
    if (Math.abs(exponent) < 10) {
      text.append('0');
    }
    return text.append(Math.abs(exponent)).toString();
  }
}

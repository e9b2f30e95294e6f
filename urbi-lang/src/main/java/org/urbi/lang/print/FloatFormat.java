package org.urbi.lang.print;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * Numbers as urbiscript shows them: six significant digits, as {@code %g} does in C, but all the
 * digits of integers (manual, "Float.asString").
 */
public final class FloatFormat {
  private static final int DIGITS = 6;
  private static final MathContext ROUND = new MathContext(DIGITS, RoundingMode.HALF_EVEN);

  private FloatFormat() {}

  /** A number as text. */
  public static String format(double value) {
    if (Double.isNaN(value)) {
      return "nan";
    } else if (Double.isInfinite(value)) {
      return value > 0 ? "inf" : "-inf";
    } else if (value == 0) {
      return 1 / value < 0 ? "-0" : "0";
    } else if (value == (long) value && Math.abs(value) < 0x1p63) {
      return Long.toString((long) value);
    }
    BigDecimal rounded = new BigDecimal(value).round(ROUND).stripTrailingZeros();
    int exponent = rounded.precision() - rounded.scale() - 1;
    if (exponent >= -4 && exponent < DIGITS) {
      return rounded.toPlainString();
    }
    String mantissa = rounded.movePointLeft(exponent).toPlainString();
    String digits = (Math.abs(exponent) < 10 ? "0" : "") + Math.abs(exponent);
    return mantissa + 'e' + (exponent < 0 ? '-' : '+') + digits;
  }
}

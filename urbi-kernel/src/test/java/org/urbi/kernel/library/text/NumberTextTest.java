package org.urbi.kernel.library.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The quick ways from texts to numbers and back do what the plain ones do. */
class NumberTextTest {
  private static final String NUMBER = "([0-9]+(\\.[0-9]*)?|\\.[0-9]+)([eE][-+]?[0-9]+)?";

  @Test
  void textsAreNumbersAsTheGrammarSays() {
    String letters = "07.eE+-x";
    int length = 4;
    for (int code = 0; code < Math.pow(letters.length() + 1, length); code++) {
      StringBuilder text = new StringBuilder();
      for (int rest = code; rest > 0; rest /= letters.length() + 1) {
        if (rest % (letters.length() + 1) > 0) {
          text.append(letters.charAt(rest % (letters.length() + 1) - 1));
        }
      }
      String digits = text.toString().replaceFirst("^[-+]", "");
      Double expected = null;
      if (digits.matches(NUMBER)) {
        expected = (text.charAt(0) == '-' ? -1 : 1) * Double.parseDouble(digits);
      }
      assertEquals(expected, StringType.parseNumber(text.toString()), text.toString());
    }
  }

  @Test
  void decimalsAreRoundedExactly() {
    Random random = new Random(1);
    for (int i = 0; i < 3_000; i++) {
      check(Math.abs(Double.longBitsToDouble(random.nextLong())), random.nextInt(12));
      check(random.nextDouble() * Math.pow(10, random.nextInt(18)), random.nextInt(12));
      // Halves, and what is next to them.
      double half = random.nextInt(1 << random.nextInt(1, 31)) / 16.0;
      check(half, random.nextInt(5));
      check(Math.nextUp(half), random.nextInt(5));
      check(Math.abs(Math.nextDown(half)), random.nextInt(5));
    }
  }

  private static void check(double size, int precision) {
    if (Double.isFinite(size)) {
      assertEquals(
          new BigDecimal(size).setScale(precision, RoundingMode.HALF_EVEN).toPlainString(),
          Formatting.fixed(size, precision),
          size + " with " + precision + " decimals");
    }
  }
}

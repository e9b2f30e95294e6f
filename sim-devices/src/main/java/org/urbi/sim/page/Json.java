package org.urbi.sim.page;

import java.util.Iterator;
import java.util.List;
import java.util.Map;

/** Writes values as JSON: maps, lists, strings, numbers, truth values and null. */
final class Json {
  private static final double DIGITS = 1e5;
  private static final double LARGE = 1e9;

  private Json() {}

  /**
   * The text of a value.
   *
   * @throws IllegalArgumentException for what JSON has no form for
   */
  static String text(Object value) {
    StringBuilder out = new StringBuilder();
    write(value, out);
    return out.toString();
  }

  private static void write(Object value, StringBuilder out) {
    switch (value) {
      case null -> out.append("null");
      case String text -> writeText(text, out);
      case Boolean truth -> out.append(truth);
      case Integer whole -> out.append(whole);
      case Long whole -> out.append(whole);
      case Double number -> writeNumber(number, out);
      case double[] numbers -> {
        out.append('[');
        for (int i = 0; i < numbers.length; i++) {
          writeNumber(numbers[i], i == 0 ? out : out.append(','));
        }
        out.append(']');
      }
      case List<?> list -> {
        out.append('[');
        for (Iterator<?> each = list.iterator(); each.hasNext(); ) {
          write(each.next(), out);
          out.append(each.hasNext() ? "," : "");
        }
        out.append(']');
      }
      case Map<?, ?> map -> {
        out.append('{');
        for (Iterator<? extends Map.Entry<?, ?>> each = map.entrySet().iterator();
            each.hasNext(); ) {
          Map.Entry<?, ?> entry = each.next();
          writeText((String) entry.getKey(), out);
          write(entry.getValue(), out.append(':'));
          out.append(each.hasNext() ? "," : "");
        }
        out.append('}');
      }
      default -> throw new IllegalArgumentException("not for JSON: " + value.getClass());
    }
  }

  /** A number with as many digits as a picture needs; null if it is not finite. */
  private static void writeNumber(double number, StringBuilder out) {
    if (!Double.isFinite(number)) {
      out.append("null");
      return;
    }
    double rounded = Math.rint(number * DIGITS) / DIGITS;
    if (Math.abs(number) > LARGE) {
      out.append(number);
    } else if (rounded == Math.rint(rounded)) {
      out.append((long) rounded);
    } else {
      out.append(rounded);
    }
  }

  private static void writeText(String text, StringBuilder out) {
    out.append('"');
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '"' || c == '\\') {
        out.append('\\').append(c);
      } else if (c < ' ' || c == '<' || c > '~') {
        out.append(String.format("\\u%04x", (int) c));
      } else {
        out.append(c);
      }
    }
    out.append('"');
  }
}

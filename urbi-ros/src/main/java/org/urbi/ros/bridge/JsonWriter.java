package org.urbi.ros.bridge;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Writes what {@link JsonReader} reads. Numbers that JSON has not are null, as rosbridge does it.
 */
final class JsonWriter {
  /** Below, doubles are whole numbers as people write them. */
  private static final double WHOLE = 1e15;

  private final StringBuilder out = new StringBuilder();

  private JsonWriter() {}

  static String text(@Nullable Object value) {
    JsonWriter writer = new JsonWriter();
    writer.write(value);
    return writer.out.toString();
  }

  private void write(@Nullable Object value) {
    switch (value) {
      case null -> out.append("null");
      case String text -> write(text);
      case Double number -> write(number.doubleValue());
      case Number number -> out.append(number);
      case Boolean truth -> out.append(truth);
      case Map<?, ?> map -> {
        String before = "{";
        for (Map.Entry<?, ?> each : map.entrySet()) {
          out.append(before);
          write(String.valueOf(each.getKey()));
          out.append(':');
          write(each.getValue());
          before = ",";
        }
        out.append(map.isEmpty() ? "{}" : "}");
      }
      case Iterable<?> list -> {
        out.append('[');
        String before = "";
        for (Object each : list) {
          out.append(before);
          write(each);
          before = ",";
        }
        out.append(']');
      }
      default -> throw new IllegalArgumentException("not for JSON: " + value.getClass());
    }
  }

  private void write(double number) {
    if (!Double.isFinite(number)) {
      out.append("null");
    } else if (number == Math.rint(number) && Math.abs(number) < WHOLE) {
      out.append((long) number);
    } else {
      out.append(number);
    }
  }

  private void write(String text) {
    out.append('"');
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      switch (c) {
        case '"', '\\' -> out.append('\\').append(c);
        case '\n' -> out.append("\\n");
        default -> {
          if (c < ' ' || Character.isSurrogate(c)) {
            out.append("\\u%04x".formatted((int) c));
          } else {
            out.append(c);
          }
        }
      }
    }
    out.append('"');
  }
}

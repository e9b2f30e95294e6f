package org.urbi.ros.message;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import urbi.UList;
import urbi.UValue;

/** Reads the values of constants, and what fields are by default. */
final class LiteralReader {
  /** No number needs more characters, and to read exact ones takes their square in time. */
  private static final int LONGEST_NUMBER = 1000;

  private LiteralReader() {}

  /**
   * Reads a value.
   *
   * @throws DefinitionException if the text is not a value of that type
   */
  static UValue read(FieldType type, String text, Dialect dialect) {
    return switch (type) {
      case FieldType.Basic(Primitive primitive) -> number(primitive, text);
      case FieldType.Text string -> {
        String read = dialect == Dialect.ROS_1 ? text : unquoted(text);
        Values.text(string, new UValue(read));
        yield new UValue(read);
      }
      case FieldType.Array array -> list(array, text, dialect);
      case FieldType.Nested(TypeName name) ->
          throw new DefinitionException("a message (" + name + ") has no value '" + text + "'");
    };
  }

  private static UValue number(Primitive primitive, String text) {
    if (text.length() > LONGEST_NUMBER) {
      throw new DefinitionException(
          "a number of " + LONGEST_NUMBER + " characters at most expected");
    }
    try {
      UValue value =
          switch (primitive) {
            case BOOL -> new UValue(bool(text));
            case FLOAT32, FLOAT64 -> new UValue(Double.parseDouble(text));
            case TIME, DURATION -> throw new NumberFormatException();
            default -> new UValue(integer(text).doubleValue());
          };
      Values.number(primitive, value);
      return value;
    } catch (NumberFormatException | ValueException e) {
      throw new DefinitionException(
          "'" + text + "' is no " + TypeReader.write(new FieldType.Basic(primitive)));
    }
  }

  private static boolean bool(String text) {
    return switch (text) {
      case "true", "True", "TRUE" -> true;
      case "false", "False", "FALSE" -> false;
      default -> new BigDecimal(text).signum() != 0;
    };
  }

  private static BigInteger integer(String text) {
    boolean negative = text.startsWith("-");
    String digits = negative || text.startsWith("+") ? text.substring(1) : text;
    BigInteger value =
        digits.startsWith("0x") || digits.startsWith("0X")
            ? new BigInteger(digits.substring(2), 16)
            : new BigInteger(digits);
    return negative ? value.negate() : value;
  }

  private static UValue list(FieldType.Array array, String text, Dialect dialect) {
    if (!text.startsWith("[") || !text.endsWith("]")) {
      throw new DefinitionException("a list in brackets expected, not '" + text + "'");
    }
    UList values = new UList();
    for (String each : elements(text.substring(1, text.length() - 1))) {
      values.add(read(array.element(), each, dialect));
    }
    Values.count(array, values.size());
    return new UValue(values);
  }

  /** What is between commas, but for those in strings. */
  private static List<String> elements(String text) {
    List<String> found = new ArrayList<>();
    int start = 0;
    for (int i = 0; i <= text.length(); i++) {
      if (i == text.length() || text.charAt(i) == ',') {
        String element = text.substring(start, i).strip();
        if (!element.isEmpty()) {
          found.add(element);
        }
        start = i + 1;
      } else {
        i = skipString(text, i);
      }
    }
    return found;
  }

  /** The place of the end of the string that begins there; the same place if none does. */
  static int skipString(String text, int place) {
    char quote = text.charAt(place);
    if (quote != '"' && quote != '\'') {
      return place;
    }
    for (int i = place + 1; i < text.length(); i++) {
      if (text.charAt(i) == '\\') {
        i++;
      } else if (text.charAt(i) == quote) {
        return i;
      }
    }
    return place;
  }

  private static String unquoted(String text) {
    if (text.length() < 2 || skipString(text, 0) != text.length() - 1) {
      return text;
    }
    return text.substring(1, text.length() - 1)
        .replace("\\\"", "\"")
        .replace("\\'", "'")
        .replace("\\\\", "\\");
  }
}

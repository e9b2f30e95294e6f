package org.urbi.ros.bridge;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Reads JSON: maps, lists, strings, numbers (as {@code Double}), truth values, null. Bounded is how
 * deep it goes; how long it is, is bounded by those who have received it.
 */
final class JsonReader {
  private static final int DEEPEST = 100;

  private final String text;
  private int at;

  private JsonReader(String text) {
    this.text = text;
  }

  /**
   * The object that a text is.
   *
   * @throws BridgeException if it is none
   */
  static Map<String, @Nullable Object> object(String text) {
    JsonReader reader = new JsonReader(text);
    Object value = reader.value(0);
    reader.space();
    if (reader.at < text.length() || !(value instanceof Map<?, ?>)) {
      throw reader.wrong("one object");
    }
    return map(value);
  }

  /** All keys of what is read are strings. */
  // The reader makes no other maps.
  @SuppressWarnings("unchecked")
  static Map<String, @Nullable Object> map(Object value) {
    return (Map<String, @Nullable Object>) value;
  }

  private BridgeException wrong(String expected) {
    return new BridgeException("no JSON at character " + at + ": " + expected + " expected");
  }

  private void space() {
    while (at < text.length() && " \t\r\n".indexOf(text.charAt(at)) >= 0) {
      at++;
    }
  }

  private boolean skip(char wanted) {
    space();
    if (at < text.length() && text.charAt(at) == wanted) {
      at++;
      return true;
    }
    return false;
  }

  private void expect(char wanted) {
    if (!skip(wanted)) {
      throw wrong("'" + wanted + "'");
    }
  }

  private @Nullable Object value(int depth) {
    if (depth > DEEPEST) {
      throw wrong("no more than " + DEEPEST + " levels");
    }
    space();
    if (at == text.length()) {
      throw wrong("a value");
    }
    return switch (text.charAt(at)) {
      case '{' -> members(depth);
      case '[' -> elements(depth);
      case '"' -> string();
      case 't' -> word("true", true);
      case 'f' -> word("false", false);
      case 'n' -> word("null", null);
      default -> number();
    };
  }

  private @Nullable Object word(String wanted, @Nullable Object value) {
    if (!text.startsWith(wanted, at)) {
      throw wrong(wanted);
    }
    at += wanted.length();
    return value;
  }

  private Map<String, @Nullable Object> members(int depth) {
    Map<String, @Nullable Object> all = new LinkedHashMap<>();
    expect('{');
    if (skip('}')) {
      return all;
    }
    do {
      space();
      String key = string();
      expect(':');
      all.put(key, value(depth + 1));
    } while (skip(','));
    expect('}');
    return all;
  }

  private List<@Nullable Object> elements(int depth) {
    List<@Nullable Object> all = new ArrayList<>();
    expect('[');
    if (skip(']')) {
      return all;
    }
    do {
      all.add(value(depth + 1));
    } while (skip(','));
    expect(']');
    return all;
  }

  private Double number() {
    int begin = at;
    while (at < text.length() && "+-.eE0123456789".indexOf(text.charAt(at)) >= 0) {
      at++;
    }
    try {
      return Double.valueOf(text.substring(begin, at));
    } catch (NumberFormatException e) {
      at = begin;
      throw wrong("a value");
    }
  }

  private String string() {
    if (at == text.length() || text.charAt(at) != '"') {
      throw wrong("'\"'");
    }
    int begin = ++at;
    int end = text.indexOf('"', begin);
    int escape = text.indexOf('\\', begin);
    if (end >= 0 && (escape < 0 || escape > end)) {
      at = end + 1;
      return text.substring(begin, end);
    }
    StringBuilder out = new StringBuilder();
    while (at < text.length() && text.charAt(at) != '"') {
      char c = text.charAt(at++);
      out.append(c == '\\' ? escaped() : c);
    }
    expect('"');
    return out.toString();
  }

  private char escaped() {
    if (at == text.length()) {
      throw wrong("a character");
    }
    char c = text.charAt(at++);
    return switch (c) {
      case 'n' -> '\n';
      case 't' -> '\t';
      case 'r' -> '\r';
      case 'b' -> '\b';
      case 'f' -> '\f';
      case '"', '\\', '/' -> c;
      case 'u' -> {
        try {
          yield (char) Integer.parseUnsignedInt(text, at, at += 4, 16);
        } catch (NumberFormatException | IndexOutOfBoundsException e) {
          throw wrong("four hexadecimal digits");
        }
      }
      default -> throw wrong("an escape of JSON");
    };
  }
}

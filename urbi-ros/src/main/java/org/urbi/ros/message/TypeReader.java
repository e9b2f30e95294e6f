package org.urbi.ros.message;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Reads the types of fields: {@code float64[36]}, {@code geometry_msgs/Point}, {@code string<=5}.
 */
final class TypeReader {
  private static final Pattern FORM =
      Pattern.compile("([\\w/]+)(?:<=(\\d{1,9}))?(\\[(<=)?(\\d{0,9})])?");

  private final Dialect dialect;
  private final String pack;

  /**
   * @param pack where messages are that are named without a package
   */
  TypeReader(Dialect dialect, String pack) {
    this.dialect = dialect;
    this.pack = pack;
  }

  /**
   * Reads a type.
   *
   * @throws DefinitionException if it is none
   */
  FieldType read(String text) {
    Matcher form = FORM.matcher(text);
    boolean bounded = text.contains("<=");
    if (!form.matches() || bounded && dialect == Dialect.ROS_1) {
      throw new DefinitionException("'" + text + "' is no type");
    }
    FieldType element = element(form.group(1), form.group(2));
    if (form.group(3) == null) {
      return element;
    }
    int size = form.group(5).isEmpty() ? 0 : Integer.parseInt(form.group(5));
    if (form.group(5).isEmpty() && form.group(4) != null) {
      throw new DefinitionException("'" + text + "' does not say how many at most");
    }
    FieldType.Length length =
        form.group(4) != null
            ? FieldType.Length.BOUNDED
            : form.group(5).isEmpty() ? FieldType.Length.ANY : FieldType.Length.FIXED;
    return new FieldType.Array(element, length, size);
  }

  private FieldType element(String word, @Nullable String bound) {
    boolean wide = word.equals("wstring") && dialect == Dialect.ROS_2;
    if (word.equals("string") || wide) {
      return new FieldType.Text(wide, bound == null ? 0 : Integer.parseInt(bound));
    }
    if (bound != null) {
      throw new DefinitionException("only strings have a length, not '" + word + "'");
    }
    for (Primitive primitive : Primitive.values()) {
      if (name(primitive).equals(word) && (dialect == Dialect.ROS_1 || !primitive.isInstant())) {
        return new FieldType.Basic(primitive);
      }
    }
    if (word.indexOf('/') < 0) {
      boolean header = word.equals("Header") && dialect == Dialect.ROS_1;
      word = (header ? "std_msgs" : pack) + "/" + word;
    }
    return new FieldType.Nested(TypeName.parse(word, TypeName.Kind.MESSAGE));
  }

  private static String name(Primitive primitive) {
    return primitive.name().toLowerCase(Locale.ROOT);
  }

  /** A type as it is written in a file; messages always with their package. */
  static String write(FieldType type) {
    return switch (type) {
      case FieldType.Basic(Primitive primitive) -> name(primitive);
      case FieldType.Text(boolean wide, int limit) ->
          (wide ? "wstring" : "string") + (limit == 0 ? "" : "<=" + limit);
      case FieldType.Nested(TypeName name) -> name.pack() + "/" + name.name();
      case FieldType.Array(FieldType element, FieldType.Length length, int size) ->
          write(element)
              + switch (length) {
                case FIXED -> "[" + size + "]";
                case BOUNDED -> "[<=" + size + "]";
                case ANY -> "[]";
              };
    };
  }
}

package org.urbi.kernel.embed;

import java.lang.reflect.Array;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.message.Message.Form;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/**
 * Conversion of values between Java and urbiscript, as copies.
 *
 * <p>To Java: Float becomes Double, Boolean Boolean, String String, List and Tuple (with Pair and
 * Triplet) an unmodifiable List, Dictionary an unmodifiable Map, nil and void null; everything else
 * becomes a {@link UrbiValue}, a handle on the object itself.
 *
 * <p>From Java, besides the same types: any Number and Duration, any CharSequence and Character,
 * {@code byte[]} (a String of these bytes), any Collection or array, any Map. Strings of urbiscript
 * are bytes: those of Java are encoded in UTF-8, and what is not UTF-8 comes back as one character
 * for each byte.
 */
public final class JavaValues {
  /** How deep containers may be nested. */
  static final int DEEPEST = 200;

  private JavaValues() {}

  // ------------------------------------------------------------------ to Java

  /** Copies an object; on the kernel thread. */
  static @Nullable Object toJava(Embedding embedding, UrbiObject object) {
    return new ToJavaConverter(embedding).copy(object, 0);
  }

  /** The form in which a value of that type is had from the kernel. */
  static Form form(Class<?> type) {
    return type == UrbiValue.class ? Form.HANDLE : type == byte[].class ? Form.BYTES : Form.COPY;
  }

  /** Gives an object the requested form; on the kernel thread. */
  static @Nullable Object toJava(Embedding embedding, UrbiObject object, Form form) {
    if (form == Form.HANDLE && object != object.world().values().voidObject) {
      return embedding.handle(object);
    }
    if (form == Form.BYTES && object instanceof UrbiString string) {
      return string.value().getBytes(StandardCharsets.ISO_8859_1);
    }
    return toJava(embedding, object);
  }

  // ------------------------------------------------------------------ as a certain type

  /**
   * Converts a value that came from urbiscript to another Java type: a Double to any number type
   * that holds it exactly, or to a Duration in seconds; a String of one character to a Character; a
   * List to an array.
   *
   * @throws ClassCastException if it cannot be one
   */
  // What is converted to a class is of it, or null; primitive types come as their wrappers.
  @SuppressWarnings("unchecked")
  public static <T> @Nullable T as(@Nullable Object value, Class<T> type) {
    return (T) converted(value, type);
  }

  private static @Nullable Object converted(@Nullable Object value, Class<?> type) {
    if (value == null) {
      if (type.isPrimitive() && type != void.class) {
        throw new ClassCastException(Problem.NIL_IS_NO.text(type.getName()));
      }
      return null;
    }
    if (type == void.class || type == Void.class) {
      return null;
    }
    if (type.isInstance(value)) {
      return value;
    }
    Object made =
        switch (value) {
          case Double number -> number(number, type);
          case Boolean truth when type == boolean.class -> truth;
          case String text when text.length() == 1 && isCharacter(type) -> text.charAt(0);
          case String text when type == byte[].class -> text.getBytes(StandardCharsets.UTF_8);
          case List<?> list when type.isArray() -> array(list, type.getComponentType());
          default -> null;
        };
    if (made == null) {
      throw new ClassCastException(
          value instanceof Number || value instanceof Boolean
              ? Problem.IS_NO.text(value, type.getName())
              : Problem.A_IS_NO.text(value.getClass().getSimpleName(), type.getName()));
    }
    return made;
  }

  private static boolean isCharacter(Class<?> type) {
    return type == char.class || type == Character.class;
  }

  private static @Nullable Object number(double d, Class<?> type) {
    if (type == double.class) {
      return d;
    }
    if (type == float.class || type == Float.class) {
      return (float) d;
    }
    if (type == Duration.class) {
      long whole = (long) Math.floor(d);
      return Double.isFinite(d) ? Duration.ofSeconds(whole, Math.round((d - whole) * 1e9)) : null;
    }
    if (d != Math.rint(d) || Math.abs(d) > 1L << 53) {
      return null;
    }
    long whole = (long) d;
    return switch (type.getName()) {
      case "long", "java.lang.Long" -> whole;
      case "int", "java.lang.Integer" -> (int) whole == whole ? (int) whole : null;
      case "short", "java.lang.Short" -> (short) whole == whole ? (short) whole : null;
      case "byte", "java.lang.Byte" -> (byte) whole == whole ? (byte) whole : null;
      default -> null;
    };
  }

  private static Object array(List<?> list, Class<?> component) {
    Object array = Array.newInstance(component, list.size());
    int i = 0;
    for (Object element : list) {
      Array.set(array, i++, converted(element, component));
    }
    return array;
  }
}

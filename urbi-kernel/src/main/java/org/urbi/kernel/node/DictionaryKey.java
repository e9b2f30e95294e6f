package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** Keys of dictionaries: equal when {@code ==} of urbiscript says so, found by {@code hash}. */
public final class DictionaryKey {
  /**
   * Carries what is in the highest bits of a hash code to all others. Whole numbers differ in the
   * highest bits of a double alone, of which a table of a few thousand entries uses hardly any.
   */
  private static final int SPREAD = 0x9E3779B9;

  private DictionaryKey() {}

  /**
   * A string. Many that share a hash code, as somebody may choose them, are found by their order.
   */
  private record TextKey(String text, UrbiObject value)
      implements UrbiDictionary.Key, Comparable<TextKey> {
    @Override
    public int compareTo(TextKey other) {
      return text.compareTo(other.text);
    }

    @Override
    public Comparable<?> rank() {
      return text;
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof TextKey key && text.equals(key.text);
    }

    @Override
    public int hashCode() {
      return text.hashCode();
    }
  }

  /** A number, found by its order where many share a hash code. */
  private record NumberKey(double number, UrbiObject value)
      implements UrbiDictionary.Key, Comparable<NumberKey> {
    @Override
    public int compareTo(NumberKey other) {
      return Double.compare(number + 0.0, other.number + 0.0);
    }

    @Override
    public Comparable<?> rank() {
      return number;
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof NumberKey key && number == key.number;
    }

    @Override
    public int hashCode() {
      // What is not a number equals nothing, not even itself: it is found nowhere.
      return Double.isNaN(number) ? System.identityHashCode(value) : hash(number);
    }
  }

  /** A key of any other type: calls its {@code ==} and {@code hash}. */
  private record ObjectKey(Frame frame, int hash, UrbiObject value) implements UrbiDictionary.Key {
    @Override
    public @Nullable Comparable<?> rank() {
      return null;
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof ObjectKey key
          && hash == key.hash
          && (value == key.value
              || Truth.of(frame, frame.interpreter.send(frame, value, "==", key.value)));
    }

    @Override
    public int hashCode() {
      return hash;
    }
  }

  /** The hash code of a number, the same for both zeros. */
  static int hash(double number) {
    return Double.hashCode(number + 0.0) * SPREAD;
  }

  /** Whether no code of urbiscript is called for such a key. */
  static boolean isPlain(UrbiObject value) {
    return value instanceof UrbiString || value instanceof UrbiFloat;
  }

  static UrbiDictionary.Key of(UrbiString value) {
    return new TextKey(value.value(), value);
  }

  static UrbiDictionary.Key of(UrbiFloat value) {
    return new NumberKey(value.value(), value);
  }

  /** The key for a value. */
  public static UrbiDictionary.Key of(Frame frame, UrbiObject value) {
    if (value instanceof UrbiString string) {
      return of(string);
    }
    if (value instanceof UrbiFloat number) {
      return of(number);
    }
    UrbiObject hash = frame.interpreter.send(frame, value, "hash");
    int code =
        switch (hash) {
          case UrbiHash known -> Long.hashCode(known.code());
          case UrbiFloat number -> Double.hashCode(number.value());
          default -> 0;
        };
    return new ObjectKey(frame, code, value);
  }
}

package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** Keys of dictionaries: equal when {@code ==} of urbiscript says so, found by {@code hash}. */
public final class DictionaryKey {
  private DictionaryKey() {}

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

  /** Whether to find such a key calls no code of urbiscript, and takes some nanoseconds at most. */
  static boolean isPlain(UrbiObject value) {
    return value instanceof UrbiString text ? text.isShort() : value instanceof UrbiFloat;
  }

  /** The key for a value. */
  public static UrbiDictionary.Key of(Frame frame, UrbiObject value) {
    if (value instanceof UrbiString string) {
      return UrbiDictionary.key(string);
    }
    if (value instanceof UrbiFloat number) {
      return UrbiDictionary.key(number);
    }
    UrbiObject hash = frame.interpreter.send(frame, value, "hash");
    return new ObjectKey(frame, code(hash), value);
  }

  private static int code(UrbiObject hash) {
    if (hash instanceof UrbiHash known) {
      return Long.hashCode(known.code());
    }
    return hash instanceof UrbiFloat number ? Double.hashCode(number.value()) : 0;
  }
}

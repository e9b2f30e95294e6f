package org.urbi.kernel.object;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * A dictionary (manual, "Dictionary"). Keys are compared by urbiscript's {@code ==} and {@code
 * hash}; {@link Key} wraps a key to do so.
 */
public final class UrbiDictionary extends UrbiObject {
  /** A key, with the equality of its value. */
  public interface Key {
    UrbiObject value();

    /** Where strings and numbers stand among their likes; null for others. */
    @Nullable Comparable<?> rank();
  }

  /**
   * Strings, then numbers, each in their natural order, then the other keys in the order of
   * insertion.
   */
  private static final Comparator<Map.Entry<Key, UrbiObject>> ORDER =
      (a, b) -> {
        Comparable<?> left = a.getKey().rank();
        Comparable<?> right = b.getKey().rank();
        if (left instanceof String s && right instanceof String t) {
          return s.compareTo(t);
        }
        if (left instanceof Double x && right instanceof Double y) {
          return x.compareTo(y);
        }
        return Integer.compare(group(left), group(right));
      };

  private static int group(@Nullable Comparable<?> rank) {
    return rank instanceof String ? 0 : rank instanceof Double ? 1 : 2;
  }

  private final LinkedHashMap<Key, UrbiObject> entries;

  public UrbiDictionary(Shape shape, Map<Key, UrbiObject> entries) {
    super(shape);
    this.entries = new LinkedHashMap<>(entries);
  }

  /** The entries, to be read. */
  public Map<Key, UrbiObject> entries() {
    noteContentRead();
    return entries;
  }

  /** The entries in an order that does not depend on the order of insertion. */
  public List<Map.Entry<Key, UrbiObject>> sorted() {
    noteContentRead();
    return entries.entrySet().stream().sorted(ORDER).toList();
  }

  /** The entries, to be modified; call {@link #noteContentChange} when it is done. */
  public Map<Key, UrbiObject> modify() {
    return entries;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiDictionary(cloneShape(), entries);
  }
}

package org.urbi.kernel.object;

import java.util.ArrayList;
import java.util.Arrays;
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
   * An entry and its place: strings, then numbers, each in their natural order, then the other keys
   * in the order of insertion.
   *
   * @param text the key if it is a string, otherwise empty
   * @param first ordered as the numbers are, and as the first characters of the strings
   */
  private record Ranked(Map.Entry<Key, UrbiObject> entry, int group, String text, long first)
      implements Comparable<Ranked> {
    private static final int CHARACTERS = 8;

    static Ranked of(Map.Entry<Key, UrbiObject> entry) {
      Comparable<?> rank = entry.getKey().rank();
      if (rank instanceof String text) {
        return new Ranked(entry, 0, text, beginning(text));
      }
      return rank instanceof Double number
          ? new Ranked(entry, 1, "", ordered(number))
          : new Ranked(entry, 2, "", 0);
    }

    /** The first characters, which are bytes; comparing them alone decides nearly always. */
    private static long beginning(String text) {
      int length = Math.min(text.length(), CHARACTERS);
      long packed = 0;
      for (int i = 0; i < length; i++) {
        packed |= (long) text.charAt(i) << Byte.SIZE * (CHARACTERS - 1 - i);
      }
      return packed ^ Long.MIN_VALUE;
    }

    /** As {@link Double#compare} orders them. */
    private static long ordered(double number) {
      long bits = Double.doubleToLongBits(number);
      return bits ^ (bits >> Long.SIZE - 1 & Long.MAX_VALUE);
    }

    @Override
    public int compareTo(Ranked other) {
      int order = group == other.group ? Long.compare(first, other.first) : group - other.group;
      return order == 0 ? text.compareTo(other.text) : order;
    }
  }

  /** Going through the entries can be ended: there may be millions. A power of two. */
  private static final int STEPS_BETWEEN_CHECKS = 1 << 10;

  private final EntryTable entries;

  public UrbiDictionary(Shape shape, Map<Key, UrbiObject> entries) {
    super(shape);
    this.entries = new EntryTable(world());
    int steps = 0;
    for (Map.Entry<Key, UrbiObject> entry : entries.entrySet()) {
      step(++steps);
      this.entries.put(entry.getKey(), entry.getValue());
    }
  }

  private UrbiDictionary(Shape shape, EntryTable entries) {
    super(shape);
    this.entries = entries;
  }

  /** The key for a string. */
  public static Key key(UrbiString value) {
    return new TextKey(value.value(), value);
  }

  /** The key for a number. */
  public static Key key(UrbiFloat value) {
    return new NumberKey(value.value(), value);
  }

  private void step(int number) {
    if ((number & (STEPS_BETWEEN_CHECKS - 1)) == 0) {
      world().passCheckpoint();
    }
  }

  /** The entries, to be read. */
  public Map<Key, UrbiObject> entries() {
    noteContentRead();
    return entries;
  }

  /** The value of a key that calls no code; null if there is none, or the key is another. */
  public @Nullable UrbiObject getPlain(UrbiObject key) {
    noteContentRead();
    if (key instanceof UrbiString text) {
      return entries.get(text);
    }
    return key instanceof UrbiFloat number ? entries.get(number) : null;
  }

  /** Sets the value of a key that calls no code; false if it is another. */
  public boolean putPlain(UrbiObject key, UrbiObject value) {
    if (key instanceof UrbiString text) {
      entries.put(text, value);
    } else if (key instanceof UrbiFloat number) {
      entries.put(number, value);
    } else {
      return false;
    }
    noteContentChange();
    return true;
  }

  /** A copy of the entries, for whoever calls code that may change them meanwhile. */
  public List<Map.Entry<Key, UrbiObject>> snapshot() {
    noteContentRead();
    List<Map.Entry<Key, UrbiObject>> copies = new ArrayList<>(entries.size());
    for (Map.Entry<Key, UrbiObject> entry : entries.entrySet()) {
      step(copies.size());
      copies.add(Map.entry(entry.getKey(), entry.getValue()));
    }
    return copies;
  }

  /** The entries in an order that does not depend on the order of insertion. */
  public List<Map.Entry<Key, UrbiObject>> sorted() {
    noteContentRead();
    Ranked[] ranked = new Ranked[entries.size()];
    int next = 0;
    for (Map.Entry<Key, UrbiObject> entry : entries.entrySet()) {
      step(next);
      ranked[next++] = Ranked.of(entry);
    }
    int[] compared = {0};
    Arrays.sort(
        ranked,
        (one, other) -> {
          step(++compared[0]);
          return one.compareTo(other);
        });
    List<Map.Entry<Key, UrbiObject>> sorted = new ArrayList<>(ranked.length);
    for (Ranked each : ranked) {
      step(sorted.size());
      sorted.add(each.entry());
    }
    return sorted;
  }

  /** The entries, to be modified; call {@link #noteContentChange} when it is done. */
  public Map<Key, UrbiObject> modify() {
    return entries;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiDictionary(cloneShape(), new EntryTable(entries));
  }
}

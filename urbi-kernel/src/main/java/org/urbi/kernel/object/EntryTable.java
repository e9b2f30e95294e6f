package org.urbi.kernel.object;

import java.security.SecureRandom;
import java.util.AbstractMap;
import java.util.AbstractSet;
import java.util.ConcurrentModificationException;
import java.util.Iterator;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiDictionary.Key;

/**
 * The entries of a dictionary in the order of their insertion. They stand one after the other, an
 * index that is at most half full tells where those of a hash code are. A look makes no object, and
 * one for the string of the look before costs a comparison.
 *
 * <p>Comparing keys may call urbiscript, which may change the table meanwhile: see {@link
 * #placeOfOther}. Keys that somebody has chosen so that they meet are told apart by hash codes that
 * nobody knows, from when they are noticed; but not those whose own code is the same.
 */
final class EntryTable extends AbstractMap<Key, UrbiObject> {
  private static final int FEWEST = 4;

  /** So many cells are copied between two checkpoints. */
  private static final int PIECE = 1 << 12;

  /**
   * So many entries get other places between two checkpoints; a power of two. It may take long to
   * find one for each, because all those that have the same code stand in its way.
   */
  private static final int FEW_ENTRIES = 1 << 6;

  /** By chance, so many entries stand in a row in no table that fits into a memory. */
  private static final int LONGEST_ROW = 128;

  /** Carries what is in the lower bits of a hash code to the highest ones, which the index uses. */
  private static final int SPREAD = 0x9E3779B9;

  private static final long WIDE_SPREAD = 0x9E3779B97F4A7C15L;
  private static final long[] NO_INDEX = {0, 0};
  private static final Key[] NO_KEYS = {};
  private static final UrbiObject[] NO_VALUES = {};

  /** For each place the key; null where it has been removed. */
  private @Nullable Key[] keys = NO_KEYS;

  private @Nullable UrbiObject[] values = NO_VALUES;

  /**
   * Cells with the hash code of an entry above, and its place, plus one, below; 0 where there is
   * none. An entry is in the first free cell after the one that its hash code tells; what has been
   * removed keeps its cell until a rebuilding.
   */
  private long[] index = NO_INDEX;

  private final World world;

  /** By how much hash codes are shifted for the index. */
  private int shift = Integer.SIZE - 1;

  /** How many places have been given, some of them to entries that have been removed. */
  private int used;

  private int size;

  /** Secret, and not 0, from when keys have met more often than chance allows. */
  private long secret;

  /** Changes when entries get other places. */
  private int rebuildings;

  private int changes;

  /** The string of the last look that has found an entry, and its place. */
  private @Nullable String lastText;

  private int lastPlace;

  /**
   * An empty table.
   *
   * @param world whose checkpoint is passed now and then, since there may be millions of entries
   */
  EntryTable(World world) {
    this.world = world;
  }

  /** A copy. */
  EntryTable(EntryTable other) {
    world = other.world;
    keys = copied(other.keys, new Key[other.keys.length], other.keys.length);
    values = copied(other.values, new UrbiObject[keys.length], keys.length);
    index = copied(other.index, new long[other.index.length], other.index.length);
    shift = other.shift;
    used = other.used;
    size = other.size;
    secret = other.secret;
  }

  private <T> T copied(T from, T to, int length) {
    for (int done = 0; done < length; done += PIECE) {
      world.passCheckpoint();
      System.arraycopy(from, done, to, done, Math.min(PIECE, length - done));
    }
    return to;
  }

  // ------------------------------------------------------------------ hash codes

  /** Whether nobody can foretell where entries are. */
  boolean isSecret() {
    return secret != 0;
  }

  private int hash(String text) {
    if (!isSecret()) {
      return text.hashCode() * SPREAD;
    }
    long code = secret;
    for (int i = 0; i < text.length(); i++) {
      code = mix(code ^ text.charAt(i));
    }
    return (int) (mix(code ^ text.length()) >>> Integer.SIZE);
  }

  private int hash(double number) {
    long bits = Double.doubleToRawLongBits(number + 0.0);
    return (int) ((isSecret() ? mix(secret ^ bits) : bits * WIDE_SPREAD) >>> Integer.SIZE);
  }

  /** One round that cannot be followed by who does not know the secret. */
  private long mix(long code) {
    long factor = secret | 1;
    return Math.multiplyHigh(code, factor) + Long.rotateRight(code * factor, Integer.SIZE);
  }

  private int hashOfCode(int code) {
    return isSecret() ? (int) (mix(secret ^ code) >>> Integer.SIZE) : code * SPREAD;
  }

  private int hash(Key key) {
    if (key instanceof TextKey text) {
      return hash(text.text());
    }
    if (key instanceof NumberKey number) {
      // What is not a number equals nothing, so that any place will do.
      return Double.isNaN(number.number()) ? used * SPREAD : hash(number.number());
    }
    return hashOfCode(key.hashCode());
  }

  // ------------------------------------------------------------------ looks

  /** The place of the entry of a string; negative if there is none. */
  private int place(String text) {
    // The very string, as it comes back from a question whether it is there.
    return isSame(text, lastText) ? lastPlace : search(text);
  }

  @SuppressWarnings("ReferenceEquality") // Equal ones are found by the search.
  private static boolean isSame(@Nullable Object one, @Nullable Object other) {
    return one == other;
  }

  private int search(String text) {
    int hash = hash(text);
    long[] cells = index;
    for (int at = hash >>> shift; ; at = at + 1 & cells.length - 1) {
      long cell = cells[at];
      int place = (int) cell - 1;
      if (place < 0) {
        return place;
      }
      if (hashIn(cell) == hash && keys[place] instanceof TextKey key && key.text().equals(text)) {
        lastText = text;
        lastPlace = place;
        return place;
      }
    }
  }

  private int place(double number) {
    int hash = hash(number);
    long[] cells = index;
    for (int at = hash >>> shift; ; at = at + 1 & cells.length - 1) {
      long cell = cells[at];
      int place = (int) cell - 1;
      if (place < 0) {
        return place;
      }
      if (hashIn(cell) == hash && keys[place] instanceof NumberKey key && key.number() == number) {
        return place;
      }
    }
  }

  private static int hashIn(long cell) {
    return (int) (cell >>> Integer.SIZE);
  }

  private int place(Object key) {
    if (key instanceof TextKey text) {
      return place(text.text());
    }
    if (key instanceof NumberKey number) {
      // It would be looked for among all the others.
      return Double.isNaN(number.number()) ? -1 : place(number.number());
    }
    return key instanceof Key other ? placeOfOther(other) : -1;
  }

  /**
   * Looks for a key that calls code. If that lets entries get other places, the look begins again;
   * an entry that it adds has a cell that is still to come, as removed ones keep theirs.
   */
  private int placeOfOther(Key key) {
    int hash = hash(key);
    int before = rebuildings;
    int at = hash >>> shift;
    while (index[at] != 0) {
      int place = (int) index[at] - 1;
      Key other = keys[place];
      if (hashIn(index[at]) == hash && other != null) {
        boolean equal = key.equals(other);
        if (before != rebuildings) {
          before = rebuildings;
          // They may have got a secret.
          hash = hash(key);
          at = hash >>> shift;
          continue;
        }
        if (equal && isSame(keys[place], other)) {
          return place;
        }
      }
      at = at + 1 & index.length - 1;
    }
    return -1;
  }

  @Nullable UrbiObject get(UrbiString key) {
    int place = place(key.value());
    return place < 0 ? null : values[place];
  }

  @Nullable UrbiObject get(UrbiFloat key) {
    int place = place(key.value());
    return place < 0 ? null : values[place];
  }

  @Override
  public @Nullable UrbiObject get(Object key) {
    int place = place(key);
    return place < 0 ? null : values[place];
  }

  @Override
  public boolean containsKey(Object key) {
    return place(key) >= 0;
  }

  @Override
  public int size() {
    return size;
  }

  // ------------------------------------------------------------------ changes

  void put(UrbiString key, UrbiObject value) {
    int place = place(key.value());
    if (place < 0) {
      append(new TextKey(key.value(), key), value);
    } else {
      values[place] = value;
    }
  }

  void put(UrbiFloat key, UrbiObject value) {
    int place = place(key.value());
    if (place < 0) {
      append(new NumberKey(key.value(), key), value);
    } else {
      values[place] = value;
    }
  }

  @Override
  public @Nullable UrbiObject put(Key key, UrbiObject value) {
    int place = place(key);
    if (place < 0) {
      append(key, value);
      return null;
    }
    UrbiObject before = values[place];
    values[place] = value;
    return before;
  }

  private void append(Key key, UrbiObject value) {
    if (used == keys.length) {
      rebuild(Math.max(FEWEST, size > keys.length / 2 ? 2 * keys.length : keys.length));
    }
    int hash = hash(key);
    int at = firstFree(hash);
    if ((at - (hash >>> shift) & index.length - 1) > LONGEST_ROW && !isSecret()) {
      // From now on keys have hash codes that nobody can foretell.
      takeOver(rebuilt(keys.length, new SecureRandom().nextLong() | 1L << 1, true));
      hash = hash(key);
      at = firstFree(hash);
    }
    enter(key, value, hash, at);
    size++;
    changes++;
  }

  /** Where an entry of that code is entered into the index. */
  private int firstFree(int hash) {
    int at = hash >>> shift;
    while (index[at] != 0) {
      at = at + 1 & index.length - 1;
    }
    return at;
  }

  private void enter(Key key, UrbiObject value, int hash, int at) {
    keys[used] = key;
    values[used] = value;
    used++;
    index[at] = (long) hash << Integer.SIZE | used;
  }

  /** Gives the entries new places, in their order, of so many. */
  private void rebuild(int places) {
    takeOver(rebuilt(places, secret, true));
  }

  /**
   * The entries in a table of so many places. How often that passes the checkpoint does not depend
   * on the secret: a recording counts it.
   *
   * @param endable whether it passes the checkpoint
   */
  private EntryTable rebuilt(int places, long itsSecret, boolean endable) {
    EntryTable next = new EntryTable(world);
    next.keys = new Key[places];
    next.values = new UrbiObject[places];
    next.index = new long[2 * places];
    next.shift = Integer.numberOfLeadingZeros(next.index.length - 1);
    next.secret = itsSecret;
    for (int i = 0; i < used; i++) {
      if (endable && (i & FEW_ENTRIES - 1) == FEW_ENTRIES - 1) {
        world.passCheckpoint();
      }
      Key key = keys[i];
      if (key != null) {
        int hash = next.hash(key);
        next.enter(key, values[i], hash, next.firstFree(hash));
      }
    }
    return next;
  }

  private void takeOver(EntryTable next) {
    keys = next.keys;
    values = next.values;
    index = next.index;
    shift = next.shift;
    secret = next.secret;
    used = next.used;
    rebuildings++;
    lastText = null;
  }

  @Override
  public @Nullable UrbiObject remove(Object key) {
    int place = place(key);
    if (place < 0) {
      return null;
    }
    UrbiObject before = values[place];
    keys[place] = null;
    values[place] = null;
    lastText = null;
    size--;
    changes++;
    if (size < keys.length / 4 && keys.length > 4 * FEWEST) {
      // Whoever goes through the few that are left does not pass all that were there. The entry is
      // removed, so nothing ends this.
      takeOver(rebuilt(keys.length / 2, secret, false));
    }
    return before;
  }

  @Override
  public void clear() {
    keys = NO_KEYS;
    values = NO_VALUES;
    index = NO_INDEX;
    shift = Integer.SIZE - 1;
    used = 0;
    size = 0;
    rebuildings++;
    changes++;
    lastText = null;
  }

  // ------------------------------------------------------------------ going through

  @Override
  public Set<Entry<Key, UrbiObject>> entrySet() {
    return new AbstractSet<>() {
      @Override
      public int size() {
        return size;
      }

      @Override
      public Iterator<Entry<Key, UrbiObject>> iterator() {
        return new Entries();
      }
    };
  }

  /** The entries as they are; like those of Java's maps it ends when the table has changed. */
  private final class Entries implements Iterator<Entry<Key, UrbiObject>> {
    private final int expected = changes;
    private int next;

    @Override
    public boolean hasNext() {
      while (next < used && keys[next] == null) {
        next++;
      }
      return next < used;
    }

    @Override
    public Entry<Key, UrbiObject> next() {
      if (expected != changes) {
        throw new ConcurrentModificationException();
      }
      if (!hasNext()) {
        throw new NoSuchElementException();
      }
      Entry<Key, UrbiObject> entry = Map.entry(keys[next], values[next]);
      next++;
      return entry;
    }
  }
}

package org.urbi.kernel.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.ConcurrentModificationException;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Random;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.object.UrbiDictionary.Key;

/** The table of dictionaries does what Java's LinkedHashMap does, whatever its keys do. */
class EntryTableTest {
  private static final int MANY = 100_000;

  private final World world = new World();
  private final Values values = world.values();
  private final EntryTable table = new EntryTable(world);

  /** A key whose comparison does something. */
  private record Acting(int number, int hash, UrbiObject value, Runnable whenCompared)
      implements Key {
    @Override
    public @Nullable Comparable<?> rank() {
      return null;
    }

    @Override
    public boolean equals(Object other) {
      whenCompared.run();
      return other instanceof Acting key && key.number == number;
    }

    @Override
    public int hashCode() {
      return hash;
    }
  }

  private Key acting(int number, int hash, Runnable whenCompared) {
    return new Acting(number, hash, values.nil, whenCompared);
  }

  private Key text(String text) {
    return UrbiDictionary.key(values.string(text));
  }

  private Key number(double number) {
    return UrbiDictionary.key(values.number(number));
  }

  private static List<UrbiObject> valuesOf(EntryTable table) {
    List<UrbiObject> found = new ArrayList<>();
    table.forEach((key, value) -> found.add(value));
    return found;
  }

  // ------------------------------------------------------------------ as Java's own

  /** One operation on both. */
  private void step(Random random, EntryTable table, Map<Key, UrbiObject> expected, int keys) {
    int name = random.nextInt(keys);
    UrbiString string = values.string("k" + name);
    UrbiFloat number = values.number(name * 0.5 - 10);
    Key key =
        switch (random.nextInt(3)) {
          case 0 -> UrbiDictionary.key(string);
          case 1 -> UrbiDictionary.key(number);
          default -> acting(name, name % 16, () -> {});
        };
    UrbiObject value = values.number(random.nextInt());
    switch (random.nextInt(12)) {
      case 0, 1, 2 -> assertEquals(expected.put(key, value), table.put(key, value));
      case 3, 4, 5 -> assertEquals(expected.remove(key), table.remove(key));
      case 6 -> assertEquals(expected.containsKey(key), table.containsKey(key));
      case 7 -> {
        table.put(string, value);
        expected.put(UrbiDictionary.key(string), value);
      }
      case 8 -> {
        table.put(number, value);
        expected.put(UrbiDictionary.key(number), value);
      }
      case 9 -> assertEquals(expected.get(UrbiDictionary.key(string)), table.get(string));
      case 10 -> assertEquals(expected.get(UrbiDictionary.key(number)), table.get(number));
      default -> assertEquals(expected.get(key), table.get(key));
    }
    assertEquals(expected.size(), table.size());
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 3, 8, 40, 1000})
  void randomOperationsGiveWhatALinkedHashMapGives(int keys) {
    Random random = new Random(keys);
    EntryTable found = table;
    Map<Key, UrbiObject> expected = new LinkedHashMap<>();
    for (int i = 0; i < 20_000; i++) {
      step(random, found, expected, keys);
      if (random.nextInt(200) == 0) {
        assertEquals(new ArrayList<>(expected.entrySet()), new ArrayList<>(found.entrySet()));
        // A copy knows nothing of what becomes of the other one.
        EntryTable before = found;
        found = new EntryTable(before);
        before.clear();
        assertTrue(before.isEmpty());
      }
      if (random.nextInt(3000) == 0) {
        found.clear();
        expected.clear();
      }
    }
    assertFalse(found.isSecret());
  }

  @Test
  void aKeyStaysTheOneThatWasThereFirst() {
    Key first = text("a");
    table.put(first, values.nil);
    table.put(text("a"), values.object);
    assertEquals(List.of(values.object), valuesOf(table));
    assertTrue(table.keySet().stream().allMatch(key -> key == first));
  }

  @Test
  void aStringThatIsChangedIsFoundAsItWas() {
    UrbiString name = values.string("abc");
    table.put(name, values.nil);
    assertEquals(values.nil, table.get(name));
    name.replace(0, 1, "x");
    assertNull(table.get(name));
    assertEquals(values.nil, table.get(values.string("abc")));
  }

  @Test
  void theLastLookIsForgottenWithItsEntry() {
    UrbiString name = values.string("a");
    table.put(name, values.nil);
    assertEquals(values.nil, table.get(name));
    table.remove(text("a"));
    assertNull(table.get(name));
    table.put(name, values.object);
    assertEquals(values.object, table.get(name));
    table.clear();
    assertNull(table.get(name));
  }

  @Test
  void bothZerosAreOneKeyAndWhatIsNoNumberIsNone() {
    table.put(values.number(0.0), values.nil);
    table.put(values.number(-0.0), values.object);
    assertEquals(List.of(values.object), valuesOf(table));
    UrbiFloat nan = values.number(Double.NaN);
    for (int i = 0; i < MANY; i++) {
      table.put(nan, values.nil);
    }
    assertEquals(MANY + 1, table.size());
    assertNull(table.get(nan));
    assertNull(table.remove(UrbiDictionary.key(nan)));
    assertFalse(table.isSecret(), "one thing many times is no reason");
  }

  @Test
  void aKeyOfAnotherKindIsNotThere() {
    table.put(text("1"), values.nil);
    assertFalse(table.containsKey(number(1)));
    assertFalse(table.containsKey("1"));
    assertFalse(table.containsKey(acting(1, "1".hashCode(), () -> {})));
  }

  // ------------------------------------------------------------------ going through

  @Test
  void goingThroughEndsWhenTheTableChanges() {
    table.put(text("a"), values.nil);
    table.put(text("b"), values.nil);
    Iterator<Map.Entry<Key, UrbiObject>> entries = table.entrySet().iterator();
    entries.next();
    table.put(text("a"), values.object);
    entries.next();
    assertThrows(NoSuchElementException.class, entries::next);
    table.remove(text("a"));
    assertThrows(ConcurrentModificationException.class, entries::next);
  }

  @Test
  void whatIsLeftKeepsItsOrderWhileTheFirstOnesAreErased() {
    for (int i = 0; i < 1000; i++) {
      table.put(text("k" + i), values.nil);
    }
    for (int i = 0; i < 1000; i++) {
      Key first = table.keySet().iterator().next();
      assertEquals(text("k" + i), first);
      table.remove(first);
    }
    assertTrue(table.isEmpty());
  }

  // ------------------------------------------------------------------ hostile keys

  /** 2^17 strings with the same hash code. */
  private static String colliding(int number) {
    StringBuilder text = new StringBuilder();
    for (int bit = 0; bit < 17; bit++) {
      text.append((number >> bit & 1) == 0 ? "Aa" : "BB");
    }
    return text.toString();
  }

  /** Numbers for which the table has the same hash code, as long as that can be foretold. */
  private static double collidingNumber(int number) {
    long inverse = 0x9E3779B97F4A7C15L;
    for (int i = 0; i < 6; i++) {
      inverse *= 2 - 0x9E3779B97F4A7C15L * inverse;
    }
    return Double.longBitsToDouble(inverse * (0x1234_5678_0000_0000L + number));
  }

  private void putAndFind(IntFunction<Key> keys) {
    for (int i = 0; i < MANY; i++) {
      table.put(keys.apply(i), values.number(i));
    }
    assertEquals(MANY, table.size());
    int next = 0;
    for (UrbiObject value : valuesOf(table)) {
      assertEquals(next++, ((UrbiFloat) value).value());
    }
    for (int i = 0; i < MANY; i++) {
      assertTrue(table.containsKey(keys.apply(i)), "entry " + i);
    }
  }

  @Test
  void stringsThatWereChosenToMeetAreToldApart() {
    assertEquals(colliding(0).hashCode(), colliding(77).hashCode());
    putAndFind(i -> text(colliding(i)));
    assertTrue(table.isSecret());
    EntryTable copy = new EntryTable(table);
    assertTrue(copy.containsKey(text(colliding(5))));
    copy.clear();
    copy.put(text("a"), values.nil);
    assertTrue(copy.containsKey(text("a")));
  }

  @Test
  void numbersThatWereChosenToMeetAreToldApart() {
    IntFunction<Key> numbers =
        i -> {
          double number = collidingNumber(i);
          // Some patterns of bits are no numbers.
          return Double.isNaN(number) ? text("nan" + i) : number(number);
        };
    putAndFind(numbers);
    assertTrue(table.isSecret());
  }

  /**
   * Each has a code of its own, but for the index all are alike as long as that can be foretold.
   */
  @Test
  void objectsThatWereChosenToMeetAreToldApart() {
    int inverse = 0x9E3779B9;
    for (int i = 0; i < 5; i++) {
      inverse *= 2 - 0x9E3779B9 * inverse;
    }
    int factor = inverse;
    putAndFind(i -> acting(i, i * factor, () -> {}));
    assertTrue(table.isSecret());
    assertTrue(new EntryTable(table).containsKey(acting(77, 77 * factor, () -> {})));
  }

  /** It may take long, so whoever is to end does so in between. */
  @Test
  void aRebuildingThatIsEndedChangesNothing() {
    for (int i = 0; i < 1024; i++) {
      table.put(number(i), values.number(i));
    }
    world.setCheckpoint(() -> {
      throw new IllegalStateException("the end");
    });
    assertThrows(IllegalStateException.class, () -> table.put(number(-1), values.nil));
    assertThrows(IllegalStateException.class, () -> table.put(number(-1), values.nil));
    assertEquals(1024, table.size());
    for (int i = 0; i < 1000; i++) {
      assertTrue(table.containsKey(number(i)));
      table.remove(number(i));
    }
    assertEquals(24, table.size(), "what is removed is removed");
    world.setCheckpoint(() -> {});
    table.put(number(-1), values.nil);
    assertEquals(25, table.size());
    assertTrue(table.containsKey(number(1023)));
  }

  @Test
  void ordinaryKeysNeedNoSecret() {
    List<IntFunction<Key>> kinds =
        List.of(
            i -> text("key" + i),
            i -> text(i + "/name"),
            i -> text(Integer.toString(i, 2)),
            this::number,
            i -> number(i * 0.1),
            i -> number(-i * 1024.0),
            i -> number(i * 1e6),
            i -> number(1.0 / (i + 1)));
    for (IntFunction<Key> keys : kinds) {
      table.clear();
      putAndFind(keys);
      assertFalse(table.isSecret(), () -> "like " + keys.apply(17).rank());
    }
  }

  // ------------------------------------------------------------------ keys that act

  /** Comparisons add, remove and clear. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
  void comparisonsMayChangeTheTable(int seed) {
    Random random = new Random(seed);
    boolean[] inside = {false};
    int[] added = {1000};
    Runnable change =
        () -> {
          if (inside[0]) {
            return;
          }
          inside[0] = true;
          switch (random.nextInt(seed == 8 ? 40 : 400)) {
            case 0 -> table.clear();
            case 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14 ->
                table.put(acting(random.nextInt(60), 7, () -> {}), values.nil);
            case 15, 16, 17, 18, 19, 20 -> {
              for (int i = 0; i < 40; i++) {
                table.put(acting(added[0]++, 7, () -> {}), values.nil);
              }
            }
            case 21, 22, 23, 24, 25, 26, 27, 28, 29, 30 -> {
              for (int i = 0; i < 40; i++) {
                table.remove(acting(random.nextInt(added[0]), 7, () -> {}));
              }
            }
            default -> {}
          }
          inside[0] = false;
        };
    for (int i = 0; i < 3000; i++) {
      int name = random.nextInt(60);
      Key key = acting(name, 7, change);
      if (random.nextBoolean()) {
        table.put(key, values.nil);
        inside[0] = true;
        assertTrue(table.containsKey(acting(name, 7, () -> {})));
        inside[0] = false;
      } else {
        table.remove(key);
      }
      if (added[0] > 3000) {
        table.clear();
        added[0] = 1000;
      }
      inside[0] = true;
      List<Key> keys = new ArrayList<>(table.keySet());
      inside[0] = false;
      assertEquals(table.size(), keys.size());
      HashSet<Integer> numbers = new HashSet<>();
      keys.forEach(one -> numbers.add(((Acting) one).number()));
      assertEquals(keys.size(), numbers.size(), "no key is there twice");
    }
  }

  @Test
  void aComparisonThatFailsChangesNothing() {
    table.put(acting(1, 7, () -> {}), values.nil);
    Key failing =
        acting(
            2,
            7,
            () -> {
              throw new IllegalStateException("no");
            });
    assertThrows(IllegalStateException.class, () -> table.put(failing, values.nil));
    assertThrows(IllegalStateException.class, () -> table.remove(failing));
    assertEquals(1, table.size());
    assertTrue(table.containsKey(acting(1, 7, () -> {})));
  }
}

package org.urbi.kernel.node;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.ConsoleTranscript;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.object.World;

/** Numbers that programs have as keys are found at once in a table of their size. */
class DictionaryKeyTest {
  private static final int KEYS = 4096;

  private final Values values = new World().values();

  /** The place in a table of Java for so many keys. */
  private static int place(int hash) {
    return (hash ^ hash >>> 16) & 2 * KEYS - 1;
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, -1, 2, 100, 1024, 0.5, 0.1, 1e6})
  void numbersInEqualStepsHaveNearlyAllAPlaceOfTheirOwn(double step) {
    Set<Integer> places = new HashSet<>();
    for (int i = 0; i < KEYS; i++) {
      places.add(place(UrbiDictionary.key(values.number(i * step)).hashCode()));
    }
    // Where chance alone decides, 3,223 places are taken.
    assertTrue(places.size() > KEYS * 6 / 10, () -> step + ": " + places.size() + " places");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0, -0.0})
  void bothZerosAreTheSame(double zero) {
    assertEquals(
        UrbiDictionary.key(values.number(0)).hashCode(),
        UrbiDictionary.key(values.number(zero)).hashCode());
  }

  /** A table of Java searches keys that meet one by one, unless they have an order. */
  @Test
  void textsWithTheSameHashCodeHaveTheOrderOfTheTexts() {
    UrbiDictionary.Key small = UrbiDictionary.key(values.string("AaAa"));
    UrbiDictionary.Key great = UrbiDictionary.key(values.string("BBBB"));
    assertEquals(small.hashCode(), great.hashCode());
    assertTrue(compare(small, great) < 0);
    assertTrue(compare(great, small) > 0);
    assertEquals(0, compare(small, UrbiDictionary.key(values.string("AaAa"))));
  }

  @Test
  void numbersWithTheSameHashCodeHaveTheirOrder() {
    double number = Double.longBitsToDouble(0x4000_0001_4000_0001L);
    UrbiDictionary.Key small = UrbiDictionary.key(values.number(0));
    UrbiDictionary.Key great = UrbiDictionary.key(values.number(number));
    assertEquals(small.hashCode(), great.hashCode());
    assertTrue(compare(small, great) < 0);
    assertEquals(0, compare(small, UrbiDictionary.key(values.number(-0.0))));
  }

  @SuppressWarnings("unchecked") // Keys of one kind are compared with each other.
  private static int compare(UrbiDictionary.Key a, UrbiDictionary.Key b) {
    return assertInstanceOf(Comparable.class, a).compareTo(b);
  }

  @Test
  void whatIsNoNumberIsSpreadBecauseNoneEqualsAnother() {
    Set<Integer> hashes = new HashSet<>();
    for (int i = 0; i < KEYS; i++) {
      hashes.add(UrbiDictionary.key(values.number(Double.NaN)).hashCode());
    }
    assertTrue(hashes.size() > KEYS / 2, () -> hashes.size() + " hash codes");
  }

  @Test
  void keysThatMeetAreFoundChangedAndErased() {
    ConsoleTranscript.check(
        """
        var d = [=>]|;
        var parts = ["Aa", "BB"]|;
        for (var a : parts) for (var b : parts) for (var c : parts) for (var e : parts)
          d[a + b + c + e] = a + b + c + e|;
        for (var key : d.keys) assert(d[key] == key)|;
        d["AaAaAaBB"] = 0|; d.erase("BBBBBBBB")|;
        [d.size, d["AaAaAaBB"], "BBBBBBBB" in d, "AaAaBBAa" in d];
        [00000000] [15, 0, false, true]
        var nans = [nan => 1, nan => 2]|; nans[nan] = 3|;
        [nans.size, nans.has(nan)];
        [00000000] [3, false]
        """);
  }
}

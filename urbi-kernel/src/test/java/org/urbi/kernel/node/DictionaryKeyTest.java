package org.urbi.kernel.node;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Numbers that programs have as keys are found at once in a table of their size. */
class DictionaryKeyTest {
  private static final int KEYS = 4096;

  /** The place in a table of Java for so many keys. */
  private static int place(int hash) {
    return (hash ^ hash >>> 16) & 2 * KEYS - 1;
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, -1, 2, 100, 1024, 0.5, 0.1, 1e6})
  void numbersInEqualStepsHaveNearlyAllAPlaceOfTheirOwn(double step) {
    Set<Integer> places = new HashSet<>();
    for (int i = 0; i < KEYS; i++) {
      places.add(place(DictionaryKey.hash(i * step)));
    }
    // Where chance alone decides, 3,223 places are taken.
    assertTrue(places.size() > KEYS * 6 / 10, () -> step + ": " + places.size() + " places");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0, -0.0})
  void bothZerosAreTheSame(double zero) {
    assertEquals(DictionaryKey.hash(0), DictionaryKey.hash(zero));
  }
}

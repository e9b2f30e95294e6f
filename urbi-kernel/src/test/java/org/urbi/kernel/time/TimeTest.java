package org.urbi.kernel.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.Kernel;

/** The clocks of a kernel, and its random numbers. */
class TimeTest {
  @Test
  void aSimulatedTimeMovesWhenItIsToldToAndNeverBack() {
    Clock clock = new VirtualClock();
    assertFalse(clock.isReal());
    assertEquals(0, clock.now());
    clock.advanceTo(5_000_000);
    assertEquals(5_000_000, clock.now());
    clock.advanceTo(3_000_000);
    assertEquals(5_000_000, clock.now());
    assertEquals(5_000_000, clock.now());
  }

  /** 2010-01-01, for every simulated kernel. */
  @Test
  void aSimulatedTimeBeginsAtTheSameMoment() {
    assertEquals(1_262_304_000.0, new VirtualClock().startTime());
  }

  @Test
  void theTimeOfTheMachineBeginsNearZeroAndPassesByItself() {
    double before = System.currentTimeMillis() / 1000.0;
    long started = System.nanoTime();
    Clock clock = new SystemClock();
    double after = System.currentTimeMillis() / 1000.0;
    assertTrue(clock.isReal());
    assertTrue(clock.startTime() >= before && clock.startTime() <= after);
    long first = clock.now();
    assertTrue(first >= 0 && first <= System.nanoTime() - started);
    long spins = 0;
    while (clock.now() == first) {
      assertTrue(++spins < 1_000_000_000L, "time stands still");
    }
    assertTrue(clock.now() > first);
    clock.advanceTo(Long.MAX_VALUE);
    assertTrue(clock.now() <= System.nanoTime() - started);
  }

  /** How long something takes that never lets others run; in simulated time nothing does. */
  @Test
  void programsMeasureWithinACycle() {
    String program =
        "{ var c = cycle | var t = time | while| (time == t) 1 | [time > t, cycle - c] };";
    try (Kernel kernel = Kernel.builder().start()) {
      assertEquals(List.of(true, 0.0), kernel.eval(program));
    }
    try (Kernel kernel = Kernel.builder().virtualTime(true).start()) {
      assertEquals(
          true, kernel.eval("{ var t = time | for| (1000) 1 | time == t && shiftedTime == t };"));
    }
  }

  /** The first outputs of SplitMix64 for the seed 1234567 are published ones. */
  @Test
  void randomNumbersAreThoseOfThePublishedGenerator() {
    RandomNumbers randomNumbers = new RandomNumbers();
    randomNumbers.seed(1_234_567);
    for (long published :
        new long[] {6457827717110365317L, 3203168211198807973L, -8629252141511181193L}) {
      assertEquals(published >>> 11, (long) randomNumbers.below(0x1p53));
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 2, 6, 1000, 1e9})
  void randomNumbersAreIntegersFromZeroToLessThanTheirBound(double bound) {
    RandomNumbers randomNumbers = new RandomNumbers();
    double sum = 0;
    for (int i = 0; i < 1000; i++) {
      double number = randomNumbers.below(bound);
      assertTrue(number >= 0 && number < bound && number == Math.rint(number));
      sum += number;
    }
    assertEquals((bound - 1) / 2, sum / 1000, bound / 10);
  }

  @Test
  void theSeedAloneDecides() {
    RandomNumbers one = new RandomNumbers();
    RandomNumbers two = new RandomNumbers();
    assertEquals(one.below(1e9), two.below(1e9));
    one.seed(7);
    two.seed(7);
    assertEquals(one.below(1e9), two.below(1e9));
    double next = one.below(1e9);
    one.seed(8);
    assertNotEquals(next, one.below(1e9));
  }
}

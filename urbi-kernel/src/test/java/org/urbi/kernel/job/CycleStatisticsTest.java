package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** How long the ticks of a kernel took, in seconds. */
class CycleStatisticsTest {
  private final CycleStatistics statistics = new CycleStatistics();

  @Test
  void withoutATickAllIsZero() {
    assertEquals(0, statistics.minimum());
    assertEquals(0, statistics.maximum());
    assertEquals(0, statistics.mean());
    assertEquals(0, statistics.variance());
    assertEquals(0, statistics.since());
  }

  @Test
  void theExtremesTheMeanAndTheVarianceAreThoseOfTheTicks() {
    statistics.add(4_000_000_000L);
    statistics.add(2_000_000_000L);
    statistics.add(9_000_000_000L);
    assertEquals(2, statistics.minimum());
    assertEquals(9, statistics.maximum());
    assertEquals(5, statistics.mean(), 1e-12);
    assertEquals((1 + 9 + 16) / 3.0, statistics.variance(), 1e-12);
  }

  @Test
  void oneTickDoesNotVary() {
    statistics.add(3_000_000_000L);
    assertEquals(3, statistics.minimum());
    assertEquals(3, statistics.maximum());
    assertEquals(3, statistics.mean());
    assertEquals(0, statistics.variance());
  }

  @Test
  void theyBeginAgain() {
    statistics.add(3_000_000_000L);
    statistics.add(5_000_000_000L);
    statistics.reset(17);
    assertEquals(17, statistics.since());
    assertEquals(0, statistics.minimum());
    assertEquals(0, statistics.maximum());
    assertEquals(0, statistics.mean());
    assertEquals(0, statistics.variance());
    statistics.add(7_000_000_000L);
    assertEquals(7, statistics.minimum());
    assertEquals(7, statistics.mean());
  }
}

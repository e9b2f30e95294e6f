package org.urbi.kernel.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RateLimitTest {
  private static final long SECOND = 1_000_000_000;

  private final RateLimit limit = new RateLimit(100);

  /** How many of those are taken, one after the other at the same time. */
  private int taken(int many, long now) {
    int taken = 0;
    for (int i = 0; i < many; i++) {
      taken += limit.take(now, 1) ? 1 : 0;
    }
    return taken;
  }

  @Test
  void whatFitsIntoASecondIsTaken() {
    for (int i = 0; i < 1000; i++) {
      assertTrue(limit.take(i * SECOND / 100, 1));
    }
  }

  @Test
  void floodGetsNoMoreThanTheLimitInEachSecond() {
    long now = 0;
    int taken = 0;
    for (int i = 0; i < 100; i++) {
      taken += taken(1000, now);
      now += SECOND / 10;
    }
    assertTrue(taken <= 1100 && taken >= 500, "taken: " + taken);
  }

  @Test
  void afterARefusalAllTheRoomIsWaitedFor() {
    assertEquals(100, taken(100, 0));
    assertFalse(limit.beginsToRefuse());
    assertFalse(limit.take(0, 1));
    assertTrue(limit.beginsToRefuse());
    assertFalse(limit.take(SECOND / 2, 1));
    assertFalse(limit.beginsToRefuse());
    assertTrue(limit.take(2 * SECOND, 1));
    assertFalse(limit.beginsToRefuse());
  }

  @Test
  void whatIsLargerThanTheRoomTakesTheRoomOfLater() {
    assertTrue(limit.take(0, 250));
    assertFalse(limit.take(SECOND, 1));
    assertTrue(limit.take(3 * SECOND, 1));
  }

  /** The clock of a machine may begin anywhere. */
  @Test
  void timeMayBeginBeforeZero() {
    assertEquals(100, taken(1000, -5 * SECOND));
    assertEquals(100, taken(1000, -3 * SECOND));
  }

  @Test
  void thereMayBeNoLimit() {
    RateLimit none = new RateLimit(Long.MAX_VALUE);
    for (int i = 0; i < 1000; i++) {
      assertTrue(none.take(i, 1L << 40));
    }
  }
}

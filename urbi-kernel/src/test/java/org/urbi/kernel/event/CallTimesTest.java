package org.urbi.kernel.event;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** What is known of calls, and how durations are counted. */
class CallTimesTest {
  @Test
  void callsAreCountedMeasuredOrNot() {
    CallTimes times = new CallTimes();
    assertEquals(0, times.count());
    assertEquals(0, times.mean());
    assertEquals(0, times.least());
    assertEquals(0, times.most());
    times.add(4_000_000_000L);
    times.add(1_000_000_000L);
    times.addUnmeasured();
    assertEquals(3, times.count());
    assertEquals(2.5, times.mean());
    assertEquals(1, times.least());
    assertEquals(4, times.most());
    times.reset();
    assertEquals(0, times.count());
    assertEquals(0, times.mean());
    assertEquals(0, times.least());
    assertEquals(0, times.most());
    times.add(7_000_000_000L);
    assertEquals(7, times.mean());
    assertEquals(7, times.least());
  }

  @Test
  void durationsAreRoundedToNanosecondsAndLimited() {
    assertEquals(1_500_000_000L, Durations.nanoseconds(1.5));
    assertEquals(1, Durations.nanoseconds(0.6e-9));
    assertEquals(0, Durations.nanoseconds(0.4e-9));
    assertEquals(0, Durations.nanoseconds(-1));
    assertEquals(1_000_000_000_000_000_000L, Durations.nanoseconds(Double.POSITIVE_INFINITY));
    assertEquals(1_000_000_000_000_000_000L, Durations.nanoseconds(1e9));
    assertEquals(0, Durations.nanoseconds(Double.NaN));
    assertEquals(1.5, Durations.seconds(1_500_000_000L));
  }
}

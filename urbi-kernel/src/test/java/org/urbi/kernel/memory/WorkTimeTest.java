package org.urbi.kernel.memory;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.time.VirtualClock;

class WorkTimeTest {
  private static final long HOUR = 3_600_000_000_000L;

  private final VirtualClock clock = new VirtualClock();
  private final GivenHeap heap = new GivenHeap();
  private final WorkTime worked = new WorkTime(clock, heap);

  @Test
  void itIsThatOfTheClockBeforeItIsPrepared() {
    clock.advanceTo(HOUR);
    assertEquals(HOUR, worked.getAsLong());
  }

  /** In an hour of that clock, this process has worked for less. */
  @Test
  void aProcessThatGetsNoProcessorHasLonger() {
    worked.prepare();
    long before = worked.getAsLong();
    clock.advanceTo(HOUR);
    assertEquals(HOUR / 5, worked.getAsLong() - before);
  }

  /** Who could not run could not give back memory, either. */
  @Test
  void aProcessThatOnlyCollectsGarbageHasLonger() {
    worked.prepare();
    long before = worked.getAsLong();
    heap.collecting = HOUR;
    clock.advanceTo(HOUR);
    assertEquals(HOUR / 3, worked.getAsLong() - before);
  }

  @Test
  void itIsNeverFasterThanTheClock() {
    worked.prepare();
    long before = worked.getAsLong();
    long end = System.currentTimeMillis() + 20;
    while (System.currentTimeMillis() < end) {
      Thread.onSpinWait();
    }
    clock.advanceTo(1000);
    long after = worked.getAsLong() - before;
    assertTrue(after >= 200 && after <= 1000, after + " ns");
  }
}

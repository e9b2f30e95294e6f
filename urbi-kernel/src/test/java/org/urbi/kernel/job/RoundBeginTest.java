package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Jobs are not to blame for what the kernel has done in the same tick before their round. */
class RoundBeginTest {
  private static final long LONG = 100_000_000;

  private final ManualClock clock = ManualClock.real();
  private final Loop loop = new Loop(clock);

  /** The ticks in which two jobs of different lobbies had their turns. */
  private final List<Long> ticks = new ArrayList<>();

  private void startTwo() {
    Scheduler scheduler = loop.scheduler;
    for (int i = 0; i < 2; i++) {
      scheduler.startDetached(
          loop.lobby(), scheduler.rootScope(), "job", job -> ticks.add(scheduler.time().cycle()));
    }
  }

  private void assertTogether() {
    loop.run();
    assertEquals(2, ticks.size());
    assertEquals(ticks.getFirst(), ticks.getLast());
  }

  @Test
  void messages() {
    startTwo();
    loop.post(() -> clock.now += LONG);
    assertTogether();
  }

  @Test
  void timers() {
    startTwo();
    loop.scheduler.timers().add(0, () -> clock.now += LONG);
    assertTogether();
  }

  @Test
  void theWaitForALookAtTheMemory() {
    startTwo();
    clock.now = LONG;
    loop.scheduler.memory().setLook(() -> clock.now += LONG);
    MemoryGate gate = loop.scheduler.memory().gate();
    gate.setMemory(() -> 1, 100);
    gate.arm();
    assertTogether();
  }
}

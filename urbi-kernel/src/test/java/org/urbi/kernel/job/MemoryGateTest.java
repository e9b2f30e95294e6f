package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** What the kernel thread may allocate before somebody has looked what of the memory is garbage. */
class MemoryGateTest {
  private static final long PERIOD = 4_000_000;

  private long allocated;
  private long free = 3200;
  private int looks;

  /** What is free after a look: all garbage has been collected. */
  private long freeAfterLook;

  private final MemoryWait memory = new MemoryWait(() -> allocated);
  private final MemoryGate gate = memory.gate();

  MemoryGateTest() {
    gate.setMemory(() -> free, 6400);
    memory.setLook(() -> {
      looks++;
      free = freeAfterLook;
    });
    gate.arm();
    gate.pass();
  }

  /** Nothing becomes garbage but what is said. */
  private void allocate(long bytes) {
    allocated += bytes;
    free -= bytes;
    gate.pass();
  }

  @Test
  void aLookIsWantedBeforeTheMemoryIsFull() {
    for (int i = 0; i < 24; i++) {
      allocate(100);
    }
    assertEquals(0, looks, "there is an eighth left");
    freeAfterLook = 800;
    allocate(400);
    assertEquals(1, looks);
    // Half of what is left is for those who look next.
    for (int i = 0; i < 3; i++) {
      allocate(100);
    }
    assertEquals(1, looks);
    freeAfterLook = 500;
    allocate(100);
    assertEquals(2, looks);
  }

  @Test
  void garbageIsNoReasonToWaitAgain() {
    freeAfterLook = 3200;
    for (int i = 0; i < 160; i++) {
      allocate(100);
    }
    // Each time when 2800 bytes have been allocated.
    assertEquals(5, looks);
  }

  /** It must get on, or nothing would be given back: the next look is not wanted at once. */
  @Test
  void whoFindsNothingFreeMayAllocateALittle() {
    allocate(3200);
    assertEquals(1, looks);
    allocated += 99;
    gate.pass();
    assertEquals(1, looks);
    assertEquals(1, gate.room(allocated));
    allocated += 1;
    gate.pass();
    assertEquals(2, looks);
  }

  /** The time of the tick is known anyway, what was allocated must be asked. */
  @Test
  void ticksPassItNowAndThen() {
    freeAfterLook = 3200;
    gate.tick(PERIOD);
    allocated += 3200;
    free = 0;
    gate.tick(2 * PERIOD - 1);
    assertEquals(0, looks);
    gate.tick(2 * PERIOD);
    assertEquals(1, looks);
  }

  /** However much is allocated in a moment of simulated time. */
  @Test
  void simulatedTimeThatStandsStillDoesNotKeepTheKernelFromLooking() {
    Loop loop = new Loop();
    loop.scheduler.memory().setLook(() -> looks++);
    loop.scheduler.memory().gate().setMemory(() -> 0, 63);
    loop.scheduler.memory().gate().arm();
    loop.machine.now = PERIOD;
    loop.start(job -> {
      looks = 0;
      loop.machine.now += PERIOD - 1;
      job.yieldNow();
      assertEquals(0, looks, "it has just looked");
      loop.machine.now += 1;
      job.yieldNow();
      assertEquals(1, looks);
    });
    loop.run();
    assertEquals(0, loop.scheduler.now());
  }

  @Test
  void nothingIsMeasuredBeforeItIsArmed() {
    MemoryGate idle =
        new MemoryGate(
            () -> {
              throw new AssertionError("asked");
            },
            memory);
    idle.tick(10 * PERIOD);
    idle.pass();
    assertEquals(Long.MAX_VALUE, idle.room(1));
  }
}

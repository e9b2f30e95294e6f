package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.budget.Resource;

/**
 * Who holds the kernel for too long, or allocates too much, ends though the watchdog does not look.
 */
class HoldMeterTest extends WatchedLoop {
  /**
   * How many checks a job of limited memory has until it ends, though the watchdog does not look;
   * at most 10,000.
   *
   * @param between what happens before each of them
   */
  private int checksUntilItEnds(long memory, Runnable between) {
    int[] checks = {0};
    watch.limitMemory();
    loop.scheduler.budgetOf(loop.object()).setLimit(Resource.MEMORY, memory);
    loop.start(job -> {
      try {
        while (checks[0] < 10_000) {
          between.run();
          job.checkInterrupted();
          checks[0]++;
        }
      } catch (TagStop ended) {
        assertEquals(1, told.size());
      }
    });
    loop.run();
    return checks[0];
  }

  /** The same for a job that allocates so much between two checks. */
  private int checksUntilItEnds(long bytes, long limit) {
    int checks = checksUntilItEnds(limit, () -> allocated += bytes);
    assertEquals(1, told.size());
    return checks;
  }

  @Test
  void theKernelThreadNoticesByItselfWhatAJobAllocates() {
    int checks = checksUntilItEnds(100, 100_000);
    assertTrue(checks > 1000 && checks < 1200, () -> checks + " checks");
  }

  @Test
  void theMoreIsAllocatedTheSoonerTheKernelThreadLooks() {
    int checks = checksUntilItEnds(50_000, 100_000);
    assertTrue(checks < 20, () -> checks + " checks");
  }

  @Test
  void theKernelThreadCountsEachTurnAlone() {
    watch.limitMemory();
    loop.scheduler.budgetOf(loop.object()).setLimit(Resource.MEMORY, 1000);
    loop.start(job -> {
      for (int i = 1; i <= 1000; i++) {
        allocated += 20;
        job.checkInterrupted();
        if (i % 40 == 0) {
          loop.scheduler.beginTurn();
        }
      }
    });
    loop.run();
    assertEquals(List.of(), told);
  }

  /** The same for one that takes so much time of the machine and of the processor. */
  private int checksUntilItIsOverdue(long time, long processor) {
    processorTime = 0;
    loop.machine.now = 0;
    return checksUntilItEnds(
        Long.MAX_VALUE - 1,
        () -> {
          loop.machine.now += time;
          processorTime += processor;
        });
  }

  /** Busy machines may keep the watchdog from looking, but not the one who holds the kernel. */
  @ParameterizedTest
  @ValueSource(longs = {1, 10})
  void theKernelThreadNoticesByItselfHowLongWhoHoldsItHasWorked(long time) {
    int checks = checksUntilItIsOverdue(time, 1);
    assertTrue(checks >= LIMIT && checks < 1.3 * LIMIT, () -> checks + " checks");
  }

  @Test
  void theLongerAJobTakesBetweenTwoChecksTheSoonerTheKernelThreadLooks() {
    int checks = checksUntilItIsOverdue(LIMIT / 4, LIMIT / 4);
    assertTrue(checks < 24, () -> checks + " checks");
  }

  @Test
  void whoGetsNoProcessorIsLeftToTheWatchdog() {
    assertEquals(10_000, checksUntilItIsOverdue(LIMIT, 0));
    assertEquals(List.of(), told);
  }

  /** What is left is for those who give back theirs; whoever has a budget keeps it. */
  @Test
  void whileMemoryIsNearlyExhaustedNobodyMayAllocateMuchAtOneGo() {
    loop.start(job -> {
      lookAt(0);
      job.checkInterrupted();
      watch.hurry(true);
      for (int i = 0; i < 100; i++) {
        job.checkInterrupted();
        allocated += 990;
      }
      assertEquals(List.of(), told);
      assertThrows(
          TagStop.class,
          () -> {
            for (int i = 0; i < 100; i++) {
              allocated += 990;
              job.checkInterrupted();
            }
          });
      assertEquals(List.of(job.name() + " null of 100000 bytes"), told);
    });
    loop.run();
    watch.hurry(false);
    loop.start(job -> {
      for (int i = 0; i < 1000; i++) {
        allocated += 990;
        job.checkInterrupted();
      }
    });
    loop.scheduler.stop();
    loop.run();
    assertEquals(1, told.size());
  }

  /** Most turns are over long before anybody looks: only what lasts is measured. */
  @Test
  void whoHoldsTheKernelWhileMemoryIsScarceWaitsUntilItIsLookedAt() {
    int[] looks = {0};
    loop.scheduler.memory().setLook(() -> looks[0]++);
    loop.scheduler.memory().gate().setMemory(() -> free, 3_200_000);
    loop.scheduler.memory().gate().arm();
    free = 100_000;
    loop.start(job -> {
      lookAt(0);
      looks[0] = 0;
      goOn(job);
      assertEquals(0, looks[0]);
      lookAt(1);
      goOn(job);
      assertEquals(1, looks[0]);
    });
    loop.start(job -> {
      assertTrue(loop.scheduler.interruptions().isMeasuring());
      assertFalse(loop.scheduler.interruptions().arePending(), "it has not lasted yet");
      lookAt(2);
      assertFalse(loop.scheduler.interruptions().isMeasuring());
    });
    loop.run();
    assertEquals(List.of(), told);
  }

  /** Even if that ends while it still lasts. */
  @Test
  void whatLastsIsMeasuredAnewWhenMemoryIsScarceAgain() {
    free = 100_000;
    loop.start(job -> {
      lookAt(0);
      watch.hurry(true);
      job.checkInterrupted();
      watch.hurry(false);
      job.checkInterrupted();
      assertFalse(loop.scheduler.interruptions().arePending());
      lookAt(1);
      assertTrue(loop.scheduler.interruptions().arePending());
    });
    loop.run();
    assertEquals(List.of(), told);
  }

  private static void goOn(Job job) {
    for (int i = 0; i < 100; i++) {
      job.checkInterrupted();
    }
  }
}

package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.journal.StopReason;
import org.urbi.kernel.time.SystemClock;

/** A job that holds the kernel for too long ends. Here the job itself moves the machine's clock. */
class HoldWatchdogTest {
  private static final long LIMIT = 1_000;

  private final Loop loop = new Loop();

  /** Of the kernel thread; by default nobody knows it. */
  private long processorTime = HoldWatchdog.UNKNOWN;

  /** By the kernel thread, in bytes. */
  private long allocated = 1_000_000;

  /** Of the process, in bytes. */
  private long free = Long.MAX_VALUE;

  private final List<String> told = new ArrayList<>();
  private final HoldWatchdog watch =
      new HoldWatchdog(
          loop.scheduler,
          loop.machine,
          new HoldWatchdog.Gauges(() -> processorTime, () -> allocated, () -> free, 3_200_000),
          LIMIT,
          (job, component, why, limit) ->
              told.add(
                  job.name()
                      + " "
                      + component
                      + (why == StopReason.GREEDY ? " of " + limit + " bytes" : "")));

  private void lookAt(long time) {
    loop.machine.now = time;
    watch.check();
  }

  private void lookAt(long time, long processor) {
    processorTime = processor;
    lookAt(time);
  }

  @Test
  void whoHoldsTheKernelForTooLongEnds() {
    loop.machine.now = 100;
    loop.start(job -> {
      watch.check();
      lookAt(100 + LIMIT - 1);
      job.checkInterrupted();
      assertEquals(List.of(), told);
      lookAt(100 + LIMIT);
      assertEquals(List.of(job.name() + " null"), told);
      lookAt(100 + 2 * LIMIT);
      assertEquals(1, told.size());
      assertThrows(TagStop.class, job::checkInterrupted);
    });
    loop.run();
    assertEquals(1, told.size());
  }

  @Test
  void aBudgetMayAllowLess() {
    loop.start(job -> {
      job.budget().setLimit(Resource.HOLD, 0);
      watch.check();
      lookAt(1);
      assertEquals(List.of(job.name() + " null"), told);
      assertThrows(TagStop.class, job::checkInterrupted);
      job.budget().setLimit(Resource.HOLD, Budget.UNLIMITED);
    });
    loop.run();
    assertEquals(1, told.size());
  }

  private void lookWith(long bytes) {
    allocated = bytes;
    watch.check();
  }

  @Test
  void whoAllocatesMoreAtOneGoThanItsBudgetAllowsEnds() {
    loop.start(job -> {
      job.budget().setLimit(Resource.MEMORY, 100);
      watch.limitMemory();
      lookWith(1_000_000);
      lookWith(1_000_100);
      job.checkInterrupted();
      assertEquals(List.of(), told);
      lookWith(1_000_101);
      assertEquals(List.of(job.name() + " null of 100 bytes"), told);
      lookWith(2_000_000);
      assertEquals(1, told.size());
      assertThrows(TagStop.class, job::checkInterrupted);
      job.budget().setLimit(Resource.MEMORY, Budget.UNLIMITED);
    });
    loop.run();
  }

  @Test
  void whatAJobAllocatesInSeveralTurnsCountsForEachAlone() {
    loop.start(job -> {
      job.budget().setLimit(Resource.MEMORY, 100);
      watch.limitMemory();
      for (int turn = 1; turn <= 3; turn++) {
        loop.scheduler.beginTurn();
        lookWith(turn * 1_000_000);
        lookWith(turn * 1_000_000 + 90);
        job.checkInterrupted();
      }
      job.budget().setLimit(Resource.MEMORY, Budget.UNLIMITED);
    });
    loop.run();
    assertEquals(List.of(), told);
  }

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

  /** However many there are, they cannot fill it. */
  @Test
  void aTurnTakesOnlyAPartOfTheMemoryThatIsFree() {
    free = 6400;
    loop.start(job -> {
      job.budget().setLimit(Resource.MEMORY, 1000);
      watch.limitMemory();
      lookWith(0);
      lookWith(100);
      assertEquals(List.of(), told);
      lookWith(101);
      assertEquals(List.of(job.name() + " null of 100 bytes"), told);
      assertThrows(TagStop.class, job::checkInterrupted);
      job.budget().setLimit(Resource.MEMORY, Budget.UNLIMITED);
    });
    loop.run();
  }

  @Test
  void whoHasNoLimitOfMemoryMayAllocate() {
    watch.limitMemory();
    loop.start(job -> {
      lookWith(0);
      lookWith(Long.MAX_VALUE);
      job.checkInterrupted();
    });
    loop.run();
    assertEquals(List.of(), told);
  }

  @Test
  void codeThatGetsNoProcessorGoesOn() {
    loop.start(job -> {
      lookAt(0, 10);
      lookAt(LIMIT / 2, 20);
      lookAt(LIMIT, 30);
      lookAt(5 * LIMIT, 20 + LIMIT / 2 - 1);
      job.checkInterrupted();
      assertEquals(List.of(), told);
      lookAt(5 * LIMIT + 1, 20 + LIMIT / 2);
      assertEquals(List.of(job.name() + " null"), told);
      assertThrows(TagStop.class, job::checkInterrupted);
    });
    loop.run();
    assertEquals(1, told.size());
  }

  /** Neither the time for which garbage is collected counts then, nor that of a component. */
  @Test
  void whileMemoryIsNearlyExhaustedNobodyMayWorkForLong() {
    watch.hurry(true);
    loop.start(job -> {
      lookAt(0, 0);
      lookAt(LIMIT, 10);
      lookAt(2 * LIMIT, 20);
      job.checkInterrupted();
      assertEquals(List.of(), told);
      lookAt(3 * LIMIT, LIMIT / 20 + 10);
      assertEquals(List.of(job.name() + " null"), told);
      assertThrows(TagStop.class, job::checkInterrupted);
    });
    loop.start(job -> {
      String outer = job.componentCode().enter("Robot.walk");
      lookAt(4 * LIMIT, 0);
      lookAt(5 * LIMIT - 1, LIMIT);
      job.componentCode().leave(outer);
    });
    loop.run();
    assertEquals(1, told.size());
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

  @Test
  void codeThatHasTheProcessorToItselfEndsOnTime() {
    loop.start(job -> {
      lookAt(0, 0);
      // A bit late.
      lookAt(LIMIT / 2 + 20, LIMIT / 2 + 20);
      lookAt(LIMIT - 1, LIMIT - 1);
      assertEquals(List.of(), told);
      lookAt(LIMIT, LIMIT);
      assertEquals(1, told.size());
      assertThrows(TagStop.class, job::checkInterrupted);
    });
    loop.run();
  }

  @Test
  void whatOneJobWorkedIsNotCountedForTheNext() {
    for (int i = 0; i < 2; i++) {
      long start = i * 2 * LIMIT;
      loop.start(job -> {
        lookAt(start, start);
        lookAt(start + LIMIT / 2, start + LIMIT / 2);
        lookAt(start + LIMIT - 1, start + LIMIT - 1);
        assertEquals(List.of(), told);
      });
    }
    loop.start(job -> {
      lookAt(4 * LIMIT);
      lookAt(5 * LIMIT);
      job.checkInterrupted();
    });
    loop.run();
    assertEquals(List.of(), told);
  }

  @Test
  void aComponentThatWaitsHoldsTheKernel() {
    loop.start(job -> {
      String outer = job.componentCode().enter("Robot.walk");
      lookAt(0, 0);
      lookAt(LIMIT / 2, 0);
      lookAt(LIMIT, 0);
      assertEquals(List.of(job.name() + " Robot.walk"), told);
      assertThrows(TagStop.class, () -> job.componentCode().leave(outer));
    });
    loop.run();
    assertEquals(1, told.size());
  }

  /** It may be called just when the time is over, and would then never return. */
  @Test
  void aComponentThatIsCalledTooLateIsInterruptedToo() {
    loop.start(job -> {
      lookAt(0);
      lookAt(LIMIT);
      assertEquals(List.of(job.name() + " null"), told);
      String outer = job.componentCode().enter("Robot.walk");
      lookAt(LIMIT + 1);
      assertThrows(InterruptedException.class, () -> new CountDownLatch(1).await());
      // It may clean up, in which it is not interrupted again.
      lookAt(LIMIT + 2);
      assertFalse(Thread.currentThread().isInterrupted());
      assertThrows(TagStop.class, () -> job.componentCode().leave(outer));
    });
    loop.run();
    assertEquals(1, told.size());
  }

  @Test
  void whatNeitherWorksNorLetsOthersRunEndsAtLast() {
    loop.start(job -> {
      lookAt(0, 0);
      lookAt(20 * LIMIT - 1, 0);
      job.checkInterrupted();
      assertEquals(List.of(), told);
      lookAt(20 * LIMIT, 0);
      assertThrows(TagStop.class, job::checkInterrupted);
    });
    loop.run();
    assertEquals(1, told.size());
  }

  @Test
  void whoLetsOthersRunMayTakeAsLongAsItLikes() {
    loop.start(job -> {
      for (int turn = 0; turn < 5; turn++) {
        lookAt(turn * LIMIT);
        lookAt(turn * LIMIT + LIMIT - 1);
        job.yieldNow();
        job.checkInterrupted();
      }
    });
    loop.run();
    assertEquals(List.of(), told);
  }

  @Test
  void afterOneThatWasEndedTheNextIsToo() {
    for (int i = 0; i < 2; i++) {
      loop.start(job -> {
        watch.check();
        lookAt(loop.machine.now + LIMIT);
        assertThrows(TagStop.class, job::checkInterrupted);
      });
    }
    loop.run();
    assertEquals(2, told.size());
  }

  @Test
  void nobodyHoldsTheKernelBetweenTheJobs() {
    watch.check();
    lookAt(LIMIT);
    assertEquals(0, watch.heldFor());
    watch.interrupt();
    assertEquals(List.of(), told);
    assertFalse(loop.scheduler.interruptions().arePending());
  }

  @Test
  void itTellsForHowLongAJobHasHeldTheKernel() {
    loop.start(job -> {
      loop.machine.now = 100;
      assertEquals(0, watch.heldFor());
      watch.check();
      assertEquals(0, watch.heldFor());
      loop.machine.now = 130;
      assertEquals(30, watch.heldFor());
      lookAt(140);
      assertEquals(40, watch.heldFor());
      job.yieldNow();
      assertEquals(0, watch.heldFor());
    });
    loop.run();
  }

  /** What waits in Java does so with an exception, as if its own thread had been interrupted. */
  @Test
  void aComponentIsNamedAndInterrupted() {
    loop.start(job -> {
      String outer = job.componentCode().enter("Robot.walk");
      watch.interrupt();
      assertEquals(List.of(job.name() + " Robot.walk"), told);
      assertThrows(InterruptedException.class, () -> new CountDownLatch(1).await());
      assertThrows(TagStop.class, () -> job.componentCode().leave(outer));
      assertFalse(Thread.currentThread().isInterrupted());
    });
    loop.run();
    assertEquals(1, told.size());
  }

  @Test
  void codeOfUrbiscriptIsNotInterruptedInJava() {
    loop.start(job -> {
      watch.interrupt();
      assertFalse(Thread.currentThread().isInterrupted());
      assertThrows(TagStop.class, job::checkInterrupted);
    });
    loop.run();
    assertEquals(1, told.size());
  }

  /** By another thread, in the machine's time: the job goes on until that has happened. */
  @Test
  void itWatchesByItself() throws InterruptedException {
    loop.machine.step = 1;
    CountDownLatch ended = new CountDownLatch(1);
    loop.start(job -> {
      HoldWatchdog.watch(
          loop.scheduler,
          1,
          () -> Long.MAX_VALUE,
          Long.MAX_VALUE,
          (held, component, why, limit) -> {
            told.add(held.name());
            ended.countDown();
          });
      boolean goesOn = true;
      while (goesOn) {
        Thread.onSpinWait();
        try {
          job.checkInterrupted();
        } catch (TagStop stop) {
          goesOn = false;
        }
      }
    });
    loop.run();
    ended.await();
    assertEquals(1, told.size());
    assertTrue(loop.scheduler.isOver());
  }

  /** The thread goes on, and ends the next one: here with the clock of the machine. */
  @Test
  void whoCannotBeToldForWantOfMemoryEndsAllTheSame() {
    AtomicInteger ended = new AtomicInteger();
    new HoldWatchdog(
            loop.scheduler,
            new SystemClock(),
            new HoldWatchdog.Gauges(
                () -> HoldWatchdog.UNKNOWN, () -> 0, () -> Long.MAX_VALUE, Long.MAX_VALUE),
            LIMIT,
            (job, component, why, limit) -> {
              ended.incrementAndGet();
              throw new OutOfMemoryError();
            })
        .start();
    for (int i = 0; i < 3; i++) {
      loop.start(job -> {
        try {
          while (true) {
            job.checkInterrupted();
          }
        } finally {
          loop.say("ended");
        }
      });
    }
    assertEquals(List.of("ended", "ended", "ended"), loop.run());
    assertEquals(3, ended.get());
  }
}

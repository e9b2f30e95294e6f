package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.time.SystemClock;

/** A job that holds the kernel for too long ends. */
class HoldWatchdogTest extends WatchedLoop {
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

package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

/** A job that holds the kernel for too long ends. Here the job itself moves the machine's clock. */
class HoldWatchdogTest {
  private static final long LIMIT = 1_000;

  private final Loop loop = new Loop();
  private final List<String> told = new ArrayList<>();
  private final HoldWatchdog watch =
      new HoldWatchdog(
          loop.scheduler,
          loop.machine,
          LIMIT,
          (job, component) -> told.add(job.name() + " " + component));

  private void lookAt(long time) {
    loop.machine.now = time;
    watch.check();
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
      String outer = job.enterComponent("Robot.walk");
      watch.interrupt();
      assertEquals(List.of(job.name() + " Robot.walk"), told);
      assertThrows(InterruptedException.class, () -> new CountDownLatch(1).await());
      assertThrows(TagStop.class, () -> job.leaveComponent(outer));
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
      loop.scheduler.limitHolding(
          1,
          (held, component) -> {
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
}

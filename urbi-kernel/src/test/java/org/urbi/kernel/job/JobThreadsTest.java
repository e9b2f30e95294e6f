package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The two ways to run jobs do the same. */
class JobThreadsTest {
  private static final long SECOND = Loop.SECOND;

  @Test
  void theFasterWayIsTheUsualOneWhereItIsOpen() {
    assertTrue(TickLoopThread.isAvailable());
    assertTrue(JobThreads.AUTO.factory() instanceof TickLoopThread.Factory);
    assertTrue(JobThreads.TICK_LOOP.factory() instanceof TickLoopThread.Factory);
    assertTrue(JobThreads.BATON.factory() instanceof HandoffThread.Factory);
    assertEquals(200_000, new Loop(JobThreads.TICK_LOOP).scheduler.maximumDepth());
    assertEquals(1_000, new Loop(JobThreads.BATON).scheduler.maximumDepth());
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void jobsTakeTurns(JobThreads threads) {
    Loop loop = new Loop(threads);
    for (String name : List.of("a", "b")) {
      loop.start(job -> {
        for (int i = 0; i < 3; i++) {
          loop.say(name + i);
          job.yieldNow();
        }
        job.sleepUntil(SECOND);
        loop.say(name + " at " + loop.scheduler.now() / SECOND);
      });
    }
    assertEquals(List.of("a0", "b0", "a1", "b1", "a2", "b2", "a at 1", "b at 1"), loop.run());
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void whatAJobThrowsEndsItAndTheLoopGoesOn(JobThreads threads) {
    Loop loop = new Loop(threads);
    Error error = new StackOverflowError();
    loop.start(job -> {
      throw error;
    });
    loop.start(job -> loop.say("on"));
    assertThrows(AssertionError.class, loop::run);
    assertEquals(List.of(error), loop.uncaught);
    assertEquals(List.of("on"), loop.said);
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void whenTheLoopEndsJobsAreLeft(JobThreads threads) {
    Loop loop = new Loop(threads);
    loop.start(job -> {
      try {
        job.waitForWake();
      } finally {
        loop.say("left");
      }
    });
    assertEquals(List.of("left"), loop.run());
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void aJobKnowsItsOwnThread(JobThreads threads) {
    Loop loop = new Loop(threads);
    Job idle = loop.start(job -> job.yieldNow());
    loop.start(job -> {
      assertTrue(job.isCurrentThread());
      assertFalse(idle.isCurrentThread());
      assertTrue(loop.scheduler.isKernelThread());
      loop.say("asked");
    });
    assertEquals(List.of("asked"), loop.run());
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void itIsSeenWhatAJobExecutes(JobThreads threads) {
    Loop loop = new Loop(threads);
    Job other = loop.start(job -> job.waitForWake());
    loop.start(job -> {
      assertTrue(
          List.of(other.stackTrace()).stream()
              .anyMatch(call -> call.getMethodName().equals("waitForWake")));
      other.wake();
      loop.say("seen");
    });
    assertEquals(List.of("seen"), loop.run());
  }

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void codeOfAComponentThatWaitsIsInterrupted(JobThreads threads) {
    Loop loop = new Loop(threads);
    loop.start(job -> {
      job.componentCode().enter("A.f");
      job.componentCode().interrupt(loop.scheduler.turn());
      assertThrows(InterruptedException.class, () -> Thread.sleep(SECOND));
      loop.say("interrupted");
    });
    assertEquals(List.of("interrupted"), loop.run());
  }

  // ------------------------------------------------------------------ what waits in Java

  /** The pool has one thread on two processors, and what it executes may wait for that thread. */
  @Test
  void aThreadThatAJobHasStartedIsNotBehindWhatTheCommonPoolExecutes() throws Exception {
    ForkJoinPool pool = ForkJoinPool.commonPool();
    CountDownLatch full = new CountDownLatch(pool.getParallelism());
    CountDownLatch done = new CountDownLatch(1);
    for (int i = 0; i < pool.getParallelism(); i++) {
      pool.execute(() -> {
        full.countDown();
        awaitEnd(done);
      });
    }
    full.await();
    Loop loop = new Loop(JobThreads.TICK_LOOP);
    loop.start(job -> {
      Thread.ofVirtual().start(done::countDown);
      awaitEnd(done);
      loop.say("it ran");
    });
    assertEquals(List.of("it ran"), loop.run());
  }

  private static void awaitEnd(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  /** Nobody else may have the kernel meanwhile. */
  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void whoWaitsInJavaKeepsTheKernel(JobThreads threads) {
    Loop loop = new Loop(threads);
    loop.start(job -> {
      LockSupport.parkNanos(1);
      loop.say("waited");
      job.sleepUntil(SECOND);
      loop.say("slept");
    });
    loop.start(job -> loop.say("other"));
    assertEquals(List.of("waited", "other", "slept"), loop.run());
  }

  /** If the loop went on, and wanted the lock as well, it would wait for the job for ever. */
  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void whoWaitsForALockKeepsTheKernel(JobThreads threads) throws InterruptedException {
    Loop loop = new Loop(threads);
    ReentrantLock lock = new ReentrantLock();
    CountDownLatch locked = new CountDownLatch(1);
    Thread holder =
        Thread.startVirtualThread(() -> {
          lock.lock();
          locked.countDown();
          while (!lock.hasQueuedThreads()) {
            Thread.onSpinWait();
          }
          lock.unlock();
        });
    locked.await();
    loop.start(job -> {
      lock.lock();
      loop.say("locked");
      lock.unlock();
      job.yieldNow();
    });
    loop.start(job -> loop.say("other"));
    assertEquals(List.of("locked", "other"), loop.run());
    holder.join();
  }

  @Test
  void aVirtualThreadThatAJobMakesIsNoJob() {
    Loop loop = new Loop(JobThreads.TICK_LOOP);
    loop.start(job -> {
      CountDownLatch done = new CountDownLatch(1);
      Thread.startVirtualThread(done::countDown);
      try {
        done.await();
      } catch (InterruptedException e) {
        throw new IllegalStateException(e);
      }
      loop.say("done");
    });
    assertEquals(List.of("done"), loop.run());
  }

  @Test
  void aVirtualThreadMayStartTheLoop() throws InterruptedException {
    Loop[] made = new Loop[1];
    Thread starter =
        Thread.startVirtualThread(() -> {
          Loop loop = new Loop(JobThreads.TICK_LOOP);
          loop.start(job -> loop.say("ran"));
          loop.run();
          made[0] = loop;
        });
    starter.join();
    assertEquals(List.of("ran"), made[0].said);
  }

  @Test
  void theThreadOfTheLoopKeepsNoProgramFromItsEnd() throws InterruptedException {
    Loop loop = new Loop(JobThreads.TICK_LOOP);
    loop.start(job -> {});
    Thread thread = loop.scheduler.startLoop(failure -> {});
    assertTrue(thread.isDaemon());
    assertEquals("urbi-kernel", thread.getName());
    thread.join();
  }
}

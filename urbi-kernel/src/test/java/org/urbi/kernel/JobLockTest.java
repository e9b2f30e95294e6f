package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.kernel.job.JobThreads;

/**
 * Jobs that wait inside Java, as for a lock of the JDK, and the kernel with them, go on even if the
 * wait ends as it begins.
 */
class JobLockTest {
  private static final int TURNS = 200_000;
  private static final int LONGEST_DELAY = 256;

  /** The turns that the job has begun, and those for which it may go on. */
  private final AtomicInteger begun = new AtomicInteger();

  private final AtomicInteger released = new AtomicInteger();
  private final CountDownLatch over = new CountDownLatch(1);
  private final Object lock = new Object();
  private volatile Thread waiting;

  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void jobsThatWaitInsideJavaGoOn(JobThreads jobThreads) throws InterruptedException {
    try (Kernel kernel = Kernel.builder().jobThreads(jobThreads).start()) {
      start(kernel);
      Thread releaser = Thread.ofPlatform().daemon().start(this::release);
      over.await();
      releaser.join();
    }
  }

  /** It has to get what it waits for, and to give it back to who waits behind it. */
  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void aKernelEndsWhenItsJobHasGotTheLock(JobThreads jobThreads) throws InterruptedException {
    Kernel kernel = Kernel.builder().jobThreads(jobThreads).start();
    Thread behind = Thread.ofPlatform().daemon().unstarted(this::takeLock);
    Thread closer = Thread.ofPlatform().daemon().unstarted(kernel::close);
    synchronized (lock) {
      start(kernel, this::takeLock);
      awaitBlocked(() -> waiting);
      behind.start();
      awaitBlocked(() -> behind);
      closer.start();
      while (closer.getState() != Thread.State.WAITING
          && closer.getState() != Thread.State.TIMED_WAITING) {
        Thread.onSpinWait();
      }
    }
    closer.join();
    behind.join();
  }

  /** Somebody else's lock is nothing simulated: an hour must not pass while a job waits for it. */
  @ParameterizedTest
  @EnumSource(names = {"TICK_LOOP", "BATON"})
  void simulatedTimeDoesNotRunAwayFromWhoWaitsInsideJava(JobThreads jobThreads)
      throws InterruptedException {
    List<String> order = new CopyOnWriteArrayList<>();
    CountDownLatch hourOver = new CountDownLatch(1);
    try (Kernel kernel = Kernel.builder().jobThreads(jobThreads).virtualTime(true).start()) {
      synchronized (lock) {
        Runnable hour =
            () -> {
              order.add("hour");
              hourOver.countDown();
            };
        start(
            kernel,
            () -> {
              startHour(kernel, hour);
              takeLock();
              order.add("lock");
            });
        awaitBlocked(() -> waiting);
        assertFalse(hourOver.await(200, TimeUnit.MILLISECONDS), "the hour is over");
      }
      hourOver.await();
    }
    assertEquals(List.of("lock", "hour"), order);
  }

  /** On the kernel thread. */
  private static void startHour(Kernel kernel, Runnable whenOver) {
    var scheduler = kernel.scheduler();
    scheduler.startDetached(
        null,
        scheduler.rootScope(),
        "asleep",
        job -> {
          job.sleepUntil(scheduler.now() + TimeUnit.HOURS.toNanos(1));
          whenOver.run();
        });
  }

  private void takeLock() {
    synchronized (lock) {
      waiting = null;
    }
  }

  private static void awaitBlocked(Supplier<Thread> thread) {
    while (thread.get() == null || thread.get().getState() != Thread.State.BLOCKED) {
      Thread.onSpinWait();
    }
  }

  private void start(Kernel kernel) {
    start(
        kernel,
        () -> {
          for (int turn = 1; turn <= TURNS; turn++) {
            begun.set(turn);
            while (released.get() < turn) {
              LockSupport.park(this);
            }
          }
        });
  }

  private void start(Kernel kernel, Runnable task) {
    var scheduler = kernel.scheduler();
    KernelThread.run(
        kernel,
        () ->
            scheduler
                .startDetached(
                    null,
                    scheduler.rootScope(),
                    "waiting",
                    job -> {
                      waiting = Thread.currentThread();
                      task.run();
                    })
                .onEnd(over::countDown));
  }

  /** Lets the job go on in each turn, sooner or later after it has begun to wait. */
  private void release() {
    for (int turn = 1; turn <= TURNS; turn++) {
      for (int spins = 0; begun.get() < turn; spins++) {
        if (spins < LONGEST_DELAY) {
          Thread.onSpinWait();
        } else {
          // On a busy machine the job has no processor while this thread has one.
          Thread.yield();
        }
      }
      for (int spins = turn % LONGEST_DELAY; spins > 0; spins--) {
        Thread.onSpinWait();
      }
      released.set(turn);
      LockSupport.unpark(waiting);
    }
  }
}

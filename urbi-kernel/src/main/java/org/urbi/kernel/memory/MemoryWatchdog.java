package org.urbi.kernel.memory;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.log.WatchFailure;
import org.urbi.kernel.outside.HeapUsage;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;

/**
 * Frees memory when it is nearly exhausted, for all kernels of the process, which share its heap.
 * There is one thread for all of them, from the start of the first until a moment after the end of
 * the last one: none could be made when memory is exhausted.
 */
public final class MemoryWatchdog {
  private static final long PERIOD_MILLISECONDS = 250;

  /** The time between two looks while somebody is about to give back memory. */
  private static final long SHORT_PERIOD_MILLISECONDS = 10;

  /** How long somebody who needs memory waits for it to be freed at most, in nanoseconds. */
  private static final long PATIENCE = 2_000_000_000;

  /** How many bytes nobody fills between two looks. */
  private static final long FAR = 2L << 30;

  /**
   * After so many looks it is prepared in any case: that takes 10 ms of the processor, of which
   * programs that end before then are spared.
   */
  private static final int LOOKS_UNPREPARED = 12;

  private static final long MILLISECOND = 1_000_000;

  private static final String WHERE = "the watch over memory";

  private static final MemoryWatchdog OF_PROCESS = new MemoryWatchdog();

  private final Clock clock = new SystemClock();
  private final WatchFailure failure = new WatchFailure(WHERE);
  private MemoryUser[] users = {};
  private @Nullable Thread thread;

  /** How many times there was no memory for something, and how often that was looked at. */
  private long wants;

  private long seen;

  /** Whether one of those that have not been looked at got no memory. */
  private boolean failed;

  /** One that looks after the kernels of nobody else. */
  MemoryWatchdog() {}

  /** Watches the memory for one more kernel, until {@link #remove}. */
  public static void add(MemoryUser user) {
    OF_PROCESS.join(user);
  }

  /** A kernel has ended. */
  public static void remove(MemoryUser user) {
    OF_PROCESS.leave(user);
  }

  /**
   * Waits until somebody has been asked to give back memory; to be called when there was none for
   * something. Each failing allocation has all garbage collected, which stops every thread and
   * takes the lock of the heap: if whoever fails tried on, the thread that looks for memory would
   * get no turn between one collection and the next.
   */
  public static void awaitRelief() {
    OF_PROCESS.await(true);
  }

  /**
   * Waits until garbage has been collected, and until somebody has been asked to give back memory
   * if that has left little room; to be called before there is none.
   */
  public static void awaitLook() {
    OF_PROCESS.await(false);
  }

  private synchronized void await(boolean none) {
    long mine = ++wants;
    failed |= none;
    notifyAll();
    long end = clock.now() + PATIENCE;
    boolean interrupted = false;
    for (long left = PATIENCE;
        thread != null && seen < mine && left > 0;
        left = end - clock.now()) {
      try {
        wait(left / MILLISECOND + 1);
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  synchronized void join(MemoryUser user) {
    if (thread == null) {
      var heap = new HeapUsage();
      var worked = new WorkTime(clock, heap);
      var rescue = new MemoryRescue(clock, worked, heap, failure::met);
      Thread made =
          Thread.ofPlatform()
              .daemon()
              .name("urbi-memory")
              .priority(Thread.MAX_PRIORITY)
              // It must not hold on to whatever the program has set up for its own threads.
              .inheritInheritableThreadLocals(false)
              .unstarted(FailureLog.THREADS.guarding(WHERE, () -> watch(heap, worked, rescue)));
      made.start();
      thread = made;
    }
    users = Arrays.copyOf(users, users.length + 1);
    users[users.length - 1] = user;
  }

  synchronized void leave(MemoryUser user) {
    users = Arrays.stream(users).filter(each -> each != user).toArray(MemoryUser[]::new);
  }

  private void watch(HeapUsage heap, WorkTime worked, MemoryRescue rescue) {
    // A small memory may be full before the first look.
    MemoryUser[] first = users();
    boolean prepared = HeapUsage.free() < FAR && first.length > 0;
    if (prepared) {
      prepare(heap, worked, first[0]);
    }
    int looks = 0;
    for (MemoryUser[] known = next(rescue); known.length > 0; known = next(rescue)) {
      long wanted = wanted();
      boolean closely = wanted > seen;
      looks++;
      if (!prepared && (looks > LOOKS_UNPREPARED || closely || HeapUsage.free() < FAR)) {
        prepared = true;
        prepare(heap, worked, known[0]);
      }
      try {
        if (takeFailure()) {
          rescue.failed(known);
        } else {
          look(rescue, known, closely);
        }
      } catch (RuntimeException | Error e) {
        // It goes on: others need it, and there may be memory again.
        failure.met(e);
      } finally {
        looked(wanted);
      }
    }
  }

  /**
   * Loads the classes that are needed when memory is exhausted: to load them then would fail, and a
   * class that could not be loaded once is missing for good.
   */
  private void prepare(HeapUsage heap, WorkTime worked, MemoryUser user) {
    try {
      heap.prepare();
      worked.prepare();
      user.prepare();
    } catch (RuntimeException | Error e) {
      // What is there of it is of use, and there may be memory again.
      failure.met(e);
    }
  }

  private synchronized MemoryUser[] users() {
    return users;
  }

  private synchronized boolean takeFailure() {
    boolean is = failed;
    failed = false;
    return is;
  }

  private synchronized long wanted() {
    return wants;
  }

  private synchronized void looked(long wanted) {
    if (wanted > seen) {
      seen = wanted;
      notifyAll();
    }
  }

  private void look(MemoryRescue rescue, MemoryUser[] known, boolean closely) {
    try {
      if (closely) {
        rescue.collect();
      }
      rescue.check(known);
    } catch (Error e) {
      // There is so little memory that not even a class can be loaded.
      rescue.rescue(known);
      failure.met(e);
    }
  }

  /**
   * Waits for the next period, or until somebody wants a look; returns nobody when there is no
   * kernel then. It does not wait less after the last one has ended: often there is another one
   * soon, which need not pay for a thread, and for the memory that it keeps.
   */
  private synchronized MemoryUser[] next(MemoryRescue rescue) {
    if (wants == seen) {
      try {
        wait(rescue.isWaiting() ? SHORT_PERIOD_MILLISECONDS : PERIOD_MILLISECONDS);
      } catch (InterruptedException e) {
        // A program may interrupt all its threads, and still needs this one.
        Thread.interrupted();
      }
    }
    if (users.length == 0) {
      thread = null;
      notifyAll();
    }
    return users;
  }
}

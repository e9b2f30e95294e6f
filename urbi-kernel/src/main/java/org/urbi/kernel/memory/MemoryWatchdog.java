package org.urbi.kernel.memory;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.outside.HeapUsage;
import org.urbi.kernel.time.SystemClock;

/**
 * Frees memory when it is nearly exhausted, for all kernels of the process, which share its heap.
 * There is one thread for all of them, from the start of the first until the end of the last one:
 * none could be made when memory is exhausted.
 */
public final class MemoryWatchdog {
  private static final long PERIOD_MILLISECONDS = 250;

  private static final MemoryWatchdog OF_PROCESS = new MemoryWatchdog();

  private MemoryUser[] users = {};
  private @Nullable Thread thread;

  private MemoryWatchdog() {}

  /** Watches the memory for one more kernel, until {@link #remove}. */
  public static void add(MemoryUser user) {
    OF_PROCESS.join(user);
  }

  /** A kernel has ended. */
  public static void remove(MemoryUser user) {
    OF_PROCESS.leave(user);
  }

  private synchronized void join(MemoryUser user) {
    if (thread == null) {
      var heap = new HeapUsage();
      var clock = new SystemClock();
      var worked = new WorkTime(clock, heap);
      var rescue = new MemoryRescue(clock, worked, heap);
      Thread made =
          Thread.ofPlatform()
              .daemon()
              .name("urbi-memory")
              .priority(Thread.MAX_PRIORITY)
              // It must not hold on to whatever the program has set up for its own threads.
              .inheritInheritableThreadLocals(false)
              .unstarted(() -> watch(heap, worked, rescue));
      made.start();
      thread = made;
    }
    users = Arrays.copyOf(users, users.length + 1);
    users[users.length - 1] = user;
  }

  private synchronized void leave(MemoryUser user) {
    users = Arrays.stream(users).filter(each -> each != user).toArray(MemoryUser[]::new);
    if (users.length == 0) {
      notifyAll();
    }
  }

  private void watch(HeapUsage heap, WorkTime worked, MemoryRescue rescue) {
    boolean prepared = false;
    for (MemoryUser[] known = next(); known.length > 0; known = next()) {
      try {
        if (!prepared) {
          prepared = true;
          heap.prepare();
          worked.prepare();
        }
        look(rescue, known);
      } catch (Error e) {
        // It goes on: others need it, and there may be memory again.
        continue;
      }
    }
  }

  private static void look(MemoryRescue rescue, MemoryUser[] known) {
    try {
      rescue.check(known);
    } catch (Error e) {
      // There is so little memory that not even a class can be loaded.
      rescue.rescue(known);
    }
  }

  /** Waits for the next period; returns at once, with nobody, when the last kernel has ended. */
  private synchronized MemoryUser[] next() {
    if (users.length > 0) {
      try {
        wait(PERIOD_MILLISECONDS);
      } catch (InterruptedException e) {
        // A program may interrupt all its threads, and still needs this one.
        Thread.interrupted();
      }
    }
    if (users.length == 0) {
      thread = null;
    }
    return users;
  }
}

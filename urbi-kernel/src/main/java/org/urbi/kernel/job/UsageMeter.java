package org.urbi.kernel.job;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.time.Clock;

/**
 * Says what the jobs of each lobby take of the kernel's thread, its time and what it allocates.
 * Only from when somebody wants to know: then it looks whenever the turn goes to another lobby.
 */
public final class UsageMeter {
  private final Clock machine;
  private @Nullable ThreadMXBean threads;
  private volatile boolean measuring;
  private volatile @Nullable Thread thread;
  private volatile @Nullable Budget charged;
  private volatile long since;
  private volatile long allocatedBefore;

  UsageMeter(Clock machine) {
    this.machine = machine;
  }

  /** Begins to measure, for good; from any thread. */
  public synchronized void begin() {
    if (threads == null) {
      // This takes some milliseconds, and no program that nobody measures has to wait for it.
      threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
      since = machine.now();
      allocatedBefore = allocated();
      measuring = true;
    }
  }

  /** The turn is that of a job with this budget; of none if it is null. On the kernel thread. */
  void turnOf(@Nullable Budget next) {
    if (next == charged) {
      return;
    }
    if (measuring) {
      charge();
    } else if (thread == null) {
      thread = Thread.currentThread();
    }
    charged = next;
  }

  private void charge() {
    long now = machine.now();
    long allocated = allocated();
    Budget before = charged;
    if (before != null) {
      before.charge(now - since, allocated - allocatedBefore);
    }
    since = now;
    allocatedBefore = allocated;
  }

  /** Where jobs have carriers of the JDK's own, what they allocate cannot be told apart. */
  private long allocated() {
    Thread kernel = thread;
    ThreadMXBean known = threads;
    return kernel == null || known == null || kernel.isVirtual()
        ? 0
        : known.getThreadAllocatedBytes(kernel.threadId());
  }

  /**
   * For how long jobs with that budget have run, in nanoseconds, since it is measured; with the
   * turn that goes on. From any thread.
   */
  public long nanoseconds(Budget of) {
    long before = of.nanoseconds();
    return measuring && charged == of ? before + machine.now() - since : before;
  }

  /** How many bytes jobs with that budget have allocated since it is measured; likewise. */
  public long bytes(Budget of) {
    long before = of.bytes();
    return measuring && charged == of ? before + allocated() - allocatedBefore : before;
  }
}

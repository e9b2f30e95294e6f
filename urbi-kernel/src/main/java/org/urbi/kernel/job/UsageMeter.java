package org.urbi.kernel.job;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.time.Clock;

/**
 * Measures how much running time and memory allocation the jobs of each lobby use. It starts when
 * somebody first asks, and then measures whenever the turn passes to another lobby.
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

  /** Starts to measure, and never stops; from any thread. */
  public synchronized void begin() {
    if (threads == null) {
      // This takes some milliseconds, which programs that are not measured must not pay.
      threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
      since = machine.now();
      allocatedBefore = allocated();
      measuring = true;
    }
  }

  /**
   * The turn passes to a job with this budget; null if to none. On the kernel thread. To measure
   * costs as much as a short turn, so the loop passes from one turn of a lobby to its next without
   * null between them, unless it does something of its own meanwhile.
   */
  void turnOf(@Nullable Budget next) {
    if (next == charged) {
      return;
    }
    if (thread == null) {
      thread = Thread.currentThread();
      // A kernel may start while memory is scarce, and is then measured before its first job.
      since = machine.now();
      allocatedBefore = allocated();
    } else if (measuring) {
      charge();
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

  /**
   * Where jobs run on carrier threads of the JDK, nobody knows what they alone have allocated:
   * there what the whole process has allocated meanwhile counts.
   */
  private long allocated() {
    Thread kernel = thread;
    ThreadMXBean known = threads;
    if (kernel == null || known == null) {
      return 0;
    }
    return kernel.isVirtual()
        ? known.getTotalThreadAllocatedBytes()
        : known.getThreadAllocatedBytes(kernel.threadId());
  }

  /**
   * For how long jobs with that budget have run since measuring started, in nanoseconds, including
   * the current turn. From any thread.
   */
  public long nanoseconds(Budget of) {
    long before = of.nanoseconds();
    return measuring && charged == of ? before + machine.now() - since : before;
  }

  /**
   * How many bytes jobs with that budget have allocated since measuring started, including the
   * current turn.
   */
  public long bytes(Budget of) {
    long before = of.bytes();
    return measuring && charged == of ? before + allocated() - allocatedBefore : before;
  }
}

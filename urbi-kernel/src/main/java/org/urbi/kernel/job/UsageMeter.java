package org.urbi.kernel.job;

import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.time.Clock;

/**
 * Measures how much running time and memory allocation the jobs of each lobby use. It starts when
 * somebody first asks, and then measures whenever the turn passes to another lobby.
 */
public final class UsageMeter {
  private final Clock machine;
  private final LongSupplier allocatedByAll;
  private volatile boolean measuring;
  private volatile boolean hasTurned;
  private volatile @Nullable Budget charged;
  private volatile long since;
  private volatile long allocatedBefore;

  /**
   * @param allocatedByAll how many bytes the jobs have allocated, on whichever threads: the loop
   *     moves to another one when a job keeps its own
   */
  UsageMeter(Clock machine, LongSupplier allocatedByAll) {
    this.machine = machine;
    this.allocatedByAll = allocatedByAll;
  }

  /** Starts to measure, and never stops; from any thread. */
  public synchronized void begin() {
    if (!measuring) {
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
    if (!hasTurned) {
      hasTurned = true;
      // A kernel may start while memory is scarce, and is then measured before its first job.
      since = machine.now();
      allocatedBefore = measuring ? allocated() : 0;
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

  private long allocated() {
    return hasTurned ? allocatedByAll.getAsLong() : 0;
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

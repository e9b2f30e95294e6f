package org.urbi.kernel.job;

import static java.util.Objects.requireNonNull;

import java.util.concurrent.locks.LockSupport;
import java.util.function.Function;
import java.util.function.ToLongFunction;
import org.jspecify.annotations.Nullable;

/**
 * The platform threads of one tick loop. There is one, unless the virtual machine refuses to put
 * the stack of a job away that lets others run: such a job keeps the thread that it is on, and the
 * loop moves to another one. Exactly one of them runs at a time: when it is the turn of a job that
 * has kept its thread, the loop lends it the turn, and waits to get that back.
 *
 * <p>A kept thread costs the memory of its stack, through which the collector of garbage looks each
 * time, so there are few of them.
 */
final class LoopThreads {
  /** How many jobs may keep their threads. */
  static final int MOST_KEPT = 4;

  private final Function<Runnable, Thread> maker;
  private @Nullable Runnable body;
  private volatile @Nullable Thread loop;

  /** Who has lent its turn; null when the loop itself runs. */
  private volatile @Nullable Thread lender;

  private volatile Costs costs = new Costs(null, 0, 0);

  /** How many are kept; for whoever has the turn. */
  private int kept;

  /**
   * Which thread has the turn, and what is to be added to its own costs for those of all of them.
   */
  private record Costs(@Nullable Thread running, long processorTime, long allocatedBytes) {
    long processorTimeOfAll() {
      return running == null ? 0 : processorTime + of(running, ThreadCosts::processorTime);
    }

    long allocatedBytesOfAll() {
      return running == null ? 0 : allocatedBytes + of(running, ThreadCosts::allocatedBytes);
    }

    Costs movedTo(Thread next) {
      return new Costs(
          next,
          processorTimeOfAll() - of(next, ThreadCosts::processorTime),
          allocatedBytesOfAll() - of(next, ThreadCosts::allocatedBytes));
    }

    /** Of a thread that has not begun, nothing is known. */
    private static long of(Thread thread, ToLongFunction<Thread> cost) {
      return Math.max(0, cost.applyAsLong(thread));
    }
  }

  /**
   * @param maker makes a thread that has not begun
   */
  LoopThreads(Function<Runnable, Thread> maker) {
    this.maker = maker;
  }

  /**
   * Starts the first thread.
   *
   * @param loop what each of them does: begins the loop, or goes on with it
   */
  Thread start(Runnable loop) {
    body = loop;
    return startNext();
  }

  private Thread startNext() {
    Thread thread = maker.apply(requireNonNull(body, "set at the start"));
    Thread before = loop;
    Costs costsBefore = costs;
    loop = thread;
    costs = before == null ? new Costs(thread, 0, 0) : costs.movedTo(thread);
    try {
      thread.start();
    } catch (OutOfMemoryError e) {
      loop = before;
      costs = costsBefore;
      throw e;
    }
    return thread;
  }

  /** Whether the calling thread, which is none of a job, is the loop's present one. */
  boolean isLoop() {
    return Thread.currentThread() == loop;
  }

  /**
   * The running job keeps its thread: the loop goes on in another one at once, or as soon as there
   * is one, and whoever has called must touch nothing but its own.
   *
   * @return false, and nothing has happened, if too many are kept or no thread can be made
   */
  boolean keep() {
    if (kept >= MOST_KEPT) {
      return false;
    }
    kept++;
    try {
      startNext();
    } catch (OutOfMemoryError e) {
      kept--;
      return false;
    }
    return true;
  }

  /** A job leaves the thread that it had kept, which is the calling one, and so ends. */
  void leaveKept() {
    kept--;
    giveBack();
  }

  /**
   * Lends the turn of the calling thread to a job that has kept another one; returns when the job
   * has given it back.
   *
   * @param theirs the thread that the job has kept
   * @param waking tells the job
   */
  void lend(Thread theirs, Runnable waking) {
    Thread own = Thread.currentThread();
    costs = costs.movedTo(theirs);
    lender = own;
    waking.run();
    while (lender != null) {
      LockSupport.park(this);
    }
    costs = costs.movedTo(own);
  }

  /** Gives the turn back to whom it was lent by; the caller must touch nothing but its own. */
  void giveBack() {
    Thread back = requireNonNull(lender, "the loop has lent the turn");
    lender = null;
    LockSupport.unpark(back);
  }

  /** See {@link JobThread.Factory#processorTime}. */
  long processorTime() {
    return costs.processorTimeOfAll();
  }

  /** See {@link JobThread.Factory#allocatedBytes}. */
  long allocatedBytes() {
    return costs.allocatedBytesOfAll();
  }
}

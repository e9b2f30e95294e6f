package org.urbi.kernel.job;

import java.util.function.LongSupplier;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.journal.StopReason;

/**
 * Measures on the kernel thread what the running job allocates, and how long it holds the kernel,
 * without letting others run, where its budget limits what it may allocate, or where it has run for
 * long. Another thread would notice too late: in a millisecond some megabytes are filled, and on a
 * busy machine the thread that watches may get no processor for a while. To measure costs as much
 * as a hundred checks, so most checks only count themselves; the more has been used between two of
 * them, the sooner the next one looks.
 */
final class HoldMeter {
  /** So many checks of a turn cost nothing: most turns have no more. */
  private static final int FREE_CHECKS = 16;

  /** Never more checks than these between two looks. */
  private static final long MOST_CHECKS = 256;

  /** How often it looks before a limit is reached, at least, if code goes on as now. */
  private static final int LOOKS = 8;

  private final LongSupplier allocated;
  private final HoldWatchdog watch;
  private final MemoryGate gate;
  private long turn = -1;
  private boolean begun;

  /** How many checks are left until it looks. */
  private long left;

  /** How many checks there were from the last look until the next one. */
  private long checks;

  /** What had been allocated when the turn was first looked at, and at the last look. */
  private long before;

  private long seen;

  /** When the turn was first looked at, and at the last look. */
  private long since;

  private long looked;

  /** The processor time of the kernel thread when the turn was first looked at. */
  private long workedBefore;

  /**
   * @param allocated how many bytes the kernel thread has allocated
   * @param watch ends who exceeds the limit
   * @param gate to be passed where memory becomes scarce
   */
  HoldMeter(LongSupplier allocated, HoldWatchdog watch, MemoryGate gate) {
    this.allocated = allocated;
    this.watch = watch;
    this.gate = gate;
  }

  /** Whether a job has a limit: by its budget, or because memory is nearly exhausted. */
  boolean isFor(Job job) {
    return watch.isHurried() || job.budget().limit(Resource.MEMORY) != Budget.UNLIMITED;
  }

  /** The job, whose turn has that number, checks whether it must end. */
  void check(Job job, long number) {
    if (number != turn) {
      turn = number;
      begun = false;
      left = FREE_CHECKS;
    } else if (--left <= 0) {
      look(job);
    }
  }

  private void look(Job job) {
    gate.pass();
    long now = allocated.getAsLong();
    long time = watch.time();
    if (begun) {
      long most = Math.min(checksOfMemory(job, now), checksOfHold(job, time));
      checks = Math.clamp(most, 1, Math.min(2 * checks, MOST_CHECKS));
    } else {
      begun = true;
      before = now;
      since = time;
      workedBefore = watch.processorTime();
      checks = 1;
    }
    seen = now;
    looked = time;
    left = checks;
  }

  /** Ends who has allocated too much; returns in how many checks that is to be looked at again. */
  private long checksOfMemory(Job job, long now) {
    long used = now - before;
    long limit = watch.mostFor(job);
    if (used > limit / LOOKS) {
      // How much is free is not asked in each short turn.
      limit = watch.memoryFor(job);
      if (used > limit) {
        watch.endOnce(job, turn, StopReason.GREEDY, limit);
      }
    }
    long room = Math.min(Math.max(0, limit - used), gate.room(now)) / LOOKS;
    return room / Math.max(1, (now - seen) / checks);
  }

  /** The same for who has held the kernel for too long. */
  private long checksOfHold(Job job, long time) {
    long limit = watch.holdFor(job);
    // The processor time takes longer to ask for than the time.
    if (time - since >= limit && watch.processorTime() - workedBefore >= limit) {
      watch.endOnce(job, turn, StopReason.OVERDUE, limit);
    }
    return limit / LOOKS / Math.max(1, (time - looked) / checks);
  }
}

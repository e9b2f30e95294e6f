package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.time.Clock;

/**
 * Measures how long the turns of each job last, while somebody looks, and keeps the latest ones of
 * the jobs that are traced. On the kernel thread.
 */
public final class TurnMeter {
  /** How many turns are kept: whoever looks too rarely misses some. */
  private static final int KEPT = 1 << 13;

  /** What is measured of a job; made when it first is, so that jobs nobody looks at have none. */
  static final class Measures {
    private long ran;
    private long waker;
    private int tracers;
  }

  private final Clock machine;

  // The turns that are kept. To keep one takes no memory: for want of it a job would lose its turn.
  private final long[] jobs = new long[KEPT];
  private final long[] wakers = new long[KEPT];
  private final long[] begins = new long[KEPT];
  private final long[] ends = new long[KEPT];
  private final @Nullable Wait[] waits = new Wait[KEPT];
  private final boolean[] last = new boolean[KEPT];

  /** Counts for the jobs for whose measures there was no memory. */
  private final Measures lost = new Measures();

  private long next;
  private @Nullable Job charged;
  private long since;
  private Wait before = Wait.TURN;
  private long waker;

  TurnMeter(Clock machine) {
    this.machine = machine;
  }

  private Measures measures(Job job) {
    Measures known = job.measures;
    if (known == null) {
      try {
        known = new Measures();
      } catch (OutOfMemoryError e) {
        // The job must have its turn all the same.
        return lost;
      }
      job.measures = known;
    }
    return known;
  }

  /** A job has become runnable because of another one; null if because of something else. */
  void woken(Job job, @Nullable Job by) {
    measures(job).waker = by == null ? 0 : by.number();
  }

  /** The turn passes to a job; null if to none. */
  void turnOf(@Nullable Job following) {
    if (following == charged) {
      return;
    }
    long now = machine.now();
    Job done = charged;
    if (done != null) {
      Measures measures = measures(done);
      measures.ran += now - since;
      if (measures.tracers > 0) {
        keep(done, now);
      }
    }
    if (following != null) {
      before = following.waitsFor();
      waker = measures(following).waker;
    }
    charged = following;
    since = now;
  }

  private void keep(Job done, long now) {
    int at = (int) (next++ % KEPT);
    jobs[at] = done.number();
    wakers[at] = waker;
    begins[at] = since;
    ends[at] = now;
    waits[at] = before;
    last[at] = done.state() == JobState.ENDED;
  }

  /** The time of the machine, in nanoseconds. */
  public long now() {
    return machine.now();
  }

  /** How long the turns of a job have lasted while somebody looked, in nanoseconds. */
  public long ran(Job job) {
    Measures known = job.measures;
    return known == null ? 0 : known.ran;
  }

  /** One more wants to see the turns of a job. */
  public void beginTrace(Job job) {
    measures(job).tracers++;
  }

  /** Ends one {@link #beginTrace}. */
  public void endTrace(Job job) {
    measures(job).tracers--;
  }

  /** The number that the next turn of a traced job gets. */
  public long next() {
    return next;
  }

  /**
   * The turns of the traced jobs, as far as they are still kept.
   *
   * @param from the number of the first one that is wanted
   */
  public List<Turn> turns(long from) {
    List<Turn> turns = new ArrayList<>();
    for (long number = Math.max(from, next - KEPT); number < next; number++) {
      int at = (int) (number % KEPT);
      Wait wait = waits[at];
      if (wait != null) {
        turns.add(new Turn(jobs[at], wakers[at], begins[at], ends[at], wait, last[at]));
      }
    }
    return turns;
  }
}

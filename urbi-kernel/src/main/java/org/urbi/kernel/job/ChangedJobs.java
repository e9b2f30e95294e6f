package org.urbi.kernel.job;

import java.util.Collection;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Which jobs have changed, and which have ended, in this order, while somebody looks: who has once
 * looked at all jobs has to look only at these again. To note one takes no memory. On the kernel
 * thread.
 */
public final class ChangedJobs {
  /** How many changes are kept: whoever looks too rarely has to look at all jobs again. */
  private static final int KEPT = 1 << 14;

  /**
   * The jobs that have changed; null for one that has ended, and for what is of no use any more.
   */
  private final @Nullable Job[] jobs = new Job[KEPT];

  /** Their numbers; 0 for what is of no use any more. */
  private final long[] numbers = new long[KEPT];

  private long next;

  /**
   * The first change that somebody may not have taken. A job that was noted since then need not be
   * noted again: whoever looks will come upon that.
   */
  private long untaken;

  /** The number of the latest job that was started. */
  private long latest;

  /** Jobs with greater numbers were started since somebody has looked: nobody knows them yet. */
  private long latestTaken;

  /**
   * @param first the number of the first change: greater than those that jobs have kept of an
   *     earlier time in which somebody looked
   */
  ChangedJobs(long first) {
    next = first;
    untaken = first;
  }

  /** A job was started, which is a change, too. */
  void started(Job job) {
    latest = job.number();
  }

  /** A job is new, has a turn, was frozen or unfrozen. */
  void changed(Job job, TurnMeter.Measures measures) {
    if (measures.changed < untaken) {
      forget(job, measures);
      measures.changed = next;
      add(job, job.number());
    }
  }

  /** A job has changed of which cannot be said whether it was noted. */
  void changed(Job job) {
    add(job, job.number());
  }

  /** A job has ended: it is not kept alive here. */
  void ended(Job job, TurnMeter.Measures measures) {
    forget(job, measures);
    if (job.number() <= latestTaken) {
      add(null, job.number());
    }
  }

  private void forget(Job job, TurnMeter.Measures measures) {
    int at = (int) (measures.changed % KEPT);
    if (jobs[at] == job) {
      jobs[at] = null;
      numbers[at] = 0;
    }
  }

  private void add(@Nullable Job job, long number) {
    int at = (int) (next++ % KEPT);
    jobs[at] = job;
    numbers[at] = number;
  }

  /** The number of the next change. */
  long next() {
    return next;
  }

  /** Whether all changes from a number on are kept. */
  public boolean areKept(long from) {
    return next - from <= KEPT;
  }

  /**
   * Somebody looks at all jobs, and later at what changes from now on.
   *
   * @param present all that there are, in the order of their numbers
   * @return the number of the first change that is left for the next time
   */
  public long takeAll(List<Job> present) {
    latest = present.isEmpty() ? latest : Math.max(latest, present.getLast().number());
    return taken();
  }

  private long taken() {
    untaken = next;
    latestTaken = latest;
    return next;
  }

  /**
   * Takes the changes from a number on, which must be {@linkplain #areKept kept}.
   *
   * @param changed gets the jobs that have changed
   * @param ended gets the numbers of those that have ended
   * @return the number of the first change that is left for the next time
   */
  public long take(long from, Collection<Job> changed, Collection<Long> ended) {
    for (long number = from; number < next; number++) {
      int at = (int) (number % KEPT);
      Job job = jobs[at];
      if (job != null) {
        changed.add(job);
      } else if (numbers[at] != 0) {
        ended.add(numbers[at]);
      }
    }
    return taken();
  }
}

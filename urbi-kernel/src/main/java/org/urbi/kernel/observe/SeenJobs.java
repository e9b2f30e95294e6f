package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.ChangedJobs;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobState;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.TurnMeter;

/**
 * The jobs that somebody has been told of. In the first round all are looked at, later those that
 * have changed: where nearly all of very many sleep, that is next to nothing. On the kernel thread.
 */
final class SeenJobs {
  /** Before the first round. */
  private static final long NEVER = -1;

  private final Scheduler scheduler;
  private final TurnMeter meter;
  private final ChangedJobs changes;
  private final SeenTags tags;
  private final Map<Long, SeenJob> seen = new HashMap<>();

  /** Those whose share of the time is told to be more than 0: without a turn it is no longer. */
  private List<Job> active = new ArrayList<>();

  // What this round is about.
  private List<Job> round = List.of();
  private int next;
  private List<Long> ended = List.of();
  private int nextEnded;
  private boolean whole;

  private long nextChange = NEVER;
  private long roundBegan;
  private long roundBefore;

  SeenJobs(Scheduler scheduler, TurnMeter meter, SeenTags tags) {
    this.scheduler = scheduler;
    this.meter = meter;
    this.changes = meter.changes();
    this.tags = tags;
  }

  /**
   * Begins a round; the one before must be over.
   *
   * @param now the time of the machine, in nanoseconds
   */
  void begin(long now) {
    roundBefore = roundBegan;
    roundBegan = now;
    next = 0;
    nextEnded = 0;
    whole = nextChange == NEVER || !changes.areKept(nextChange);
    if (whole) {
      round = scheduler.jobs();
      ended = new ArrayList<>(seen.keySet());
      nextChange = changes.takeAll(round);
    } else {
      round = active;
      ended = new ArrayList<>();
      nextChange = changes.take(nextChange, round, ended);
    }
    active = new ArrayList<>();
  }

  /**
   * Goes on with the round, as far as it is allowed.
   *
   * @param changed gets the jobs that are new, or have changed
   * @param gone gets the numbers of those that have ended
   * @return whether the round is over
   */
  boolean look(long now, Allowance allowance, List<JobRow> changed, List<Long> gone) {
    for (; next < round.size() && allowance.isLeft(); next++) {
      Job job = round.get(next);
      allowance.use(1);
      if (job.state() != JobState.ENDED) {
        look(job, now, allowance, changed);
      }
    }
    for (; nextEnded < ended.size() && allowance.isLeft(); nextEnded++) {
      long number = ended.get(nextEnded);
      allowance.use(1);
      SeenJob known = seen.get(number);
      if (known != null && known.isOver()) {
        seen.remove(number);
        gone.add(number);
      }
    }
    return next == round.size() && nextEnded == ended.size();
  }

  private void look(Job job, long now, Allowance allowance, List<JobRow> changed) {
    SeenJob known = seen.get(job.number());
    if (known == null) {
      known = new SeenJob(job, now, meter.ran(job));
      seen.put(job.number(), known);
    }
    if (known.update(tags, roundBefore, now, meter.ran(job))) {
      allowance.use(Allowance.JOB);
      changed.add(known.row());
    }
    if (known.isActive()) {
      active.add(job);
    }
  }

  /** The job of that number; null if there is none, or it has not been told of. */
  @Nullable Job job(long number) {
    SeenJob known = seen.get(number);
    if (known != null) {
      return known.isOver() ? null : known.job();
    }
    return whole ? find(number) : null;
  }

  /** The job of that number among those of a round over all jobs, which is in their order. */
  private @Nullable Job find(long number) {
    int low = 0;
    int high = round.size() - 1;
    while (low <= high) {
      int middle = (low + high) >>> 1;
      Job found = round.get(middle);
      if (found.number() == number) {
        return found.state() == JobState.ENDED ? null : found;
      } else if (found.number() < number) {
        low = middle + 1;
      } else {
        high = middle - 1;
      }
    }
    return null;
  }
}

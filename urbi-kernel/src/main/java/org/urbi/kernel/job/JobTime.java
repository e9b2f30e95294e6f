package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;

/**
 * The time of a job, which stands still while the job is frozen: until when it sleeps, and for how
 * long it has been frozen.
 */
final class JobTime implements Runnable {
  private final Job job;
  private Timers.@Nullable Timer timer;

  /** How many frozen tags are around it; frozen alone it counts as one of them. */
  private int frozenDepth;

  private boolean frozenAlone;

  /** Whether its turn came while it was frozen, so that it is in no queue. */
  private boolean held;

  private long frozenSince;
  private long shift;

  JobTime(Job job, int frozenDepth, long shift) {
    this.job = job;
    this.frozenDepth = frozenDepth;
    this.frozenSince = now();
    this.shift = shift;
  }

  private long now() {
    return job.scheduler().now();
  }

  boolean isFrozen() {
    return frozenDepth > 0;
  }

  /** How many nanoseconds it has been frozen in all. */
  long shift() {
    return shift;
  }

  /** When its sleep ends, in nanoseconds of the scheduler; -1 if it does not sleep. */
  long deadline() {
    return timer == null ? -1 : timer.deadline();
  }

  /** The job will be woken at that time of the scheduler. */
  void sleepUntil(long deadline) {
    timer = job.scheduler().timers().addUncounted(deadline, job.account(), this);
    if (frozenDepth > 0) {
      timer.cancel();
    }
  }

  /** The sleep is over. */
  @Override
  public void run() {
    timer = null;
    job.makeRunnable();
  }

  /** The job does not sleep any more. */
  void endSleep() {
    Timers.Timer sleep = timer;
    if (sleep != null) {
      timer = null;
      sleep.cancel();
    }
  }

  /** The running job has come under so many frozen tags. */
  void moveUnder(int frozenTags) {
    int depth = frozenTags + (frozenAlone ? 1 : 0);
    if (depth > 0 && frozenDepth == 0) {
      frozenSince = now();
    }
    frozenDepth = depth;
  }

  /** Freezes the job, whatever the tags around it do. */
  void freezeAlone() {
    if (!frozenAlone) {
      frozenAlone = true;
      freeze();
    }
  }

  void unfreezeAlone() {
    if (frozenAlone) {
      frozenAlone = false;
      unfreeze();
    }
  }

  /** One more tag around it is frozen. */
  void freeze() {
    if (frozenDepth++ == 0) {
      frozenSince = now();
      if (timer != null) {
        timer.cancel();
      }
    }
  }

  /** One less tag around it is frozen. */
  void unfreeze() {
    if (--frozenDepth == 0) {
      long now = now();
      shift += now - frozenSince;
      if (timer != null) {
        long left = timer.deadline() - frozenSince;
        timer = job.scheduler().timers().moved(timer, now + left, this);
      } else if (release()) {
        job.scheduler().enqueue(job);
      }
    }
  }

  /** The turn of the frozen job has come. */
  void hold() {
    held = true;
  }

  /** Whether the job was held; it is no longer. */
  boolean release() {
    boolean was = held;
    held = false;
    return was;
  }
}

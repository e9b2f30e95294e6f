package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;

/**
 * The time of a job, which stands still while the job is frozen: until when it sleeps, and for how
 * long it has been frozen.
 */
final class JobTime implements Runnable {
  private final Job job;
  private Timers.@Nullable Timer timer;

  private boolean frozenByTags;
  private boolean frozenAlone;

  /** Whether its turn came while it was frozen, so that it is in no queue. */
  private boolean held;

  private long frozenSince;
  private long shift;

  JobTime(Job job, boolean frozenByTags, long shift) {
    this.job = job;
    this.frozenByTags = frozenByTags;
    this.frozenSince = now();
    this.shift = shift;
  }

  private long now() {
    return job.scheduler().now();
  }

  boolean isFrozen() {
    return frozenByTags || frozenAlone;
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
    if (isFrozen()) {
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

  /** Says whether a tag around the job is frozen. */
  void setFrozenByTags(boolean is) {
    freeze(is, frozenAlone);
  }

  /** Freezes the job, whatever the tags around it do, or no longer. */
  void setFrozenAlone(boolean is) {
    freeze(frozenByTags, is);
  }

  /** Whatever has frozen the job does so no longer. */
  void unfreeze() {
    freeze(false, false);
  }

  private void freeze(boolean byTags, boolean alone) {
    boolean was = isFrozen();
    frozenByTags = byTags;
    frozenAlone = alone;
    if (isFrozen() && !was) {
      standStill();
    } else if (was && !isFrozen()) {
      goOn();
    }
  }

  private void standStill() {
    job.scheduler().observation().changed(job);
    frozenSince = now();
    if (timer != null) {
      timer.cancel();
    }
  }

  private void goOn() {
    job.scheduler().observation().changed(job);
    long now = now();
    shift += now - frozenSince;
    if (timer != null) {
      long left = timer.deadline() - frozenSince;
      timer = job.scheduler().timers().moved(timer, now + left, this);
    } else if (release()) {
      job.scheduler().enqueue(job);
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

package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.time.Clock;

/** Has the jobs measured as long as somebody looks at them. On the kernel thread. */
public final class Observation {
  private final Clock machine;
  private @Nullable TurnMeter meter;
  private int observers;

  /** The number of the first change that the next meter notes. */
  private long firstChange = 1;

  Observation(Clock machine) {
    this.machine = machine;
  }

  /** From now on somebody looks: turns are measured, changes noted. */
  public TurnMeter begin() {
    TurnMeter measuring = meter == null ? new TurnMeter(machine, firstChange) : meter;
    meter = measuring;
    observers++;
    return measuring;
  }

  /** Ends one {@link #begin}. */
  public void end() {
    TurnMeter measured = meter;
    if (--observers == 0 && measured != null) {
      firstChange = measured.changes().next();
      meter = null;
    }
  }

  /** A job has been started by another one; null if by something else. */
  void started(Job job, @Nullable Job by) {
    if (meter != null) {
      meter.started(job, by);
    }
  }

  /** A job has become runnable because of another one; null if because of something else. */
  void woken(Job job, @Nullable Job by) {
    if (meter != null) {
      meter.woken(job, by);
    }
  }

  /** The turn passes to a job; null if to none. */
  void turnOf(@Nullable Job following) {
    if (meter != null) {
      meter.turnOf(following);
    }
  }

  /** The turn of the running job is told as if it was over: it may have no end. */
  public void cutTurn() {
    turnOf(null);
  }

  /** A job was frozen or unfrozen. */
  void changed(Job job) {
    if (meter != null) {
      meter.changed(job);
    }
  }

  /** A job has ended. */
  void ended(Job job) {
    if (meter != null) {
      meter.ended(job);
    }
  }
}

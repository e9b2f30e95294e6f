package org.urbi.kernel.event;

import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.JobOwner;
import org.urbi.kernel.job.Scheduler;

/**
 * Decides whether, how often and in which job a subscriber to values or events is called, and
 * measures the calls (manual, "Customizing data-flow links").
 */
public final class CallPolicy {
  private boolean enabled = true;
  private boolean asynchronous;
  private long minInterval;
  private boolean passed;
  private long firstPassed;
  private long lastPassed;
  private boolean running;
  private final CallTimes times = new CallTimes();

  public boolean isEnabled() {
    return enabled;
  }

  public void setEnabled(boolean on) {
    enabled = on;
  }

  /**
   * Whether calls are made in a job of their own; changes that occur while that job runs are
   * dropped.
   */
  public boolean isAsynchronous() {
    return asynchronous;
  }

  public void setAsynchronous(boolean on) {
    asynchronous = on;
  }

  /** The minimum time between two calls, in nanoseconds; changes that occur earlier are dropped. */
  public long minInterval() {
    return minInterval;
  }

  public void setMinInterval(long nanoseconds) {
    minInterval = nanoseconds;
  }

  /** How often calls have been made, and how long they took. */
  public CallTimes times() {
    return times;
  }

  /** The number of calls per second, from the first to the last call. */
  public double fireRate() {
    return times.count() < 2 || lastPassed <= firstPassed
        ? 0
        : (times.count() - 1) * 1e9 / (lastPassed - firstPassed);
  }

  /** Makes a call on behalf of a job, unless it is to be dropped. */
  public void call(Job caller, Job.Body body) {
    Scheduler scheduler = caller.scheduler();
    long now = scheduler.now();
    if (!enabled || passed && now - lastPassed < minInterval) {
      return;
    }
    // Reading the clock may take as long as the call, so only one call in each tick is measured.
    boolean measured = !passed || now != lastPassed;
    if (!asynchronous) {
      begin(now);
      run(caller, body, measured);
    } else if (!running) {
      running = true;
      begin(now);
      JobOwner.start(scheduler, caller.lobby(), "connection", job -> run(job, body, measured))
          .onEnd(() -> running = false);
    }
  }

  private void begin(long now) {
    if (times.count() == 0) {
      firstPassed = now;
    }
    passed = true;
    lastPassed = now;
  }

  private void run(Job job, Job.Body body, boolean measured) {
    if (!measured) {
      times.addUnmeasured();
      body.run(job);
      return;
    }
    long started = job.scheduler().measure();
    try {
      body.run(job);
    } finally {
      times.add(job.scheduler().measure() - started);
    }
  }
}

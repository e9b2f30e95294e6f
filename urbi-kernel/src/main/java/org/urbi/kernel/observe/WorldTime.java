package org.urbi.kernel.observe;

import org.urbi.kernel.job.Scheduler;

/** The time of a kernel as others count it. On the kernel thread. */
final class WorldTime {
  private static final double MICROSECOND = 1e6;
  private static final int NANOSECONDS = 1000;

  private final Scheduler scheduler;
  private final long start;

  WorldTime(Scheduler scheduler) {
    this.scheduler = scheduler;
    start = Math.round(scheduler.clock().startTime() * MICROSECOND) * NANOSECONDS;
  }

  /** In nanoseconds since the Epoch. */
  long now() {
    return start + scheduler.now();
  }
}

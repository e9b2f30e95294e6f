package org.urbi.kernel.time;

/**
 * The source of time. Only the scheduler reads it, once at the beginning of each tick: everything
 * within a tick happens at the same time.
 */
public interface Clock {
  /** Nanoseconds since the kernel was started. */
  long now();

  /** Seconds from the Epoch to the start of the kernel. */
  double startTime();

  /**
   * Whether this is real time. If not, the scheduler moves the time to the next deadline by {@link
   * #advanceTo} as soon as nothing is left to run.
   */
  boolean isReal();

  /** Moves simulated time forward; does nothing for real time. */
  void advanceTo(long nanoseconds);
}

package org.urbi.kernel.time;

/**
 * Where time comes from. The scheduler reads it once at the beginning of each tick, and nobody else
 * does: what happens within a tick happens at the same time.
 */
public interface Clock {
  /** Nanoseconds since the kernel was started. */
  long now();

  /** Seconds from the Epoch to the start of the kernel. */
  double startTime();

  /**
   * Whether time passes by itself. When it does not, nobody waits: the scheduler moves the time to
   * the next deadline with {@link #advanceTo} as soon as nothing is left to run.
   */
  boolean isReal();

  /** Moves a simulated time forward; does nothing when the time passes by itself. */
  void advanceTo(long nanoseconds);
}

package org.urbi.sim.time;

/**
 * The time of this process, for worlds that are not plugged into a kernel: that kernel's clock is
 * in another process.
 */
public final class ProcessTime {
  private static final double NANOSECONDS = 1e9;

  private final long start = System.nanoTime();

  /** Seconds since this object was made. */
  public double seconds() {
    return (System.nanoTime() - start) / NANOSECONDS;
  }
}

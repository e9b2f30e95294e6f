package org.urbi.ros.time;

/** A clock that never jumps: what waits, waits by it. */
public final class SteadyClock {
  private SteadyClock() {}

  /** Nanoseconds from some beginning that does not change. */
  public static long nanoseconds() {
    return System.nanoTime();
  }
}

package org.urbi.ros.rtps;

import org.urbi.ros.time.SteadyClock;

/**
 * How fast fragments are sent. A receiver's buffer holds three or four of the largest datagrams; a
 * burst of more is lost, and is sent twice. So a few are sent at once, then as many as the time
 * allows; whoever misses some slows it down.
 */
final class Pacing {
  private static final long BURST = 128 << 10;
  private static final double FASTEST = 1;
  private static final double SLOWEST = 125;
  private static final double FIRST = 3;
  private static final long BETWEEN_CHANGES = 5_000_000;

  private double nanosPerByte = FIRST;
  private long free = SteadyClock.nanoseconds();
  private long slowed = free;

  /** Nanoseconds until something may be sent; 0 or less: now. */
  long pause(long now) {
    return free - now - (long) (BURST * nanosPerByte);
  }

  void sent(int bytes, long now) {
    if (free - now < 0) free = now;
    free += (long) (bytes * nanosPerByte);
  }

  /** Something was lost. */
  void slower(long now) {
    if (now - slowed < BETWEEN_CHANGES) return;
    slowed = now;
    nanosPerByte = Math.min(SLOWEST, nanosPerByte * 1.5);
  }

  /** A sample arrived as it was sent. */
  void faster(long now) {
    if (now - slowed < BETWEEN_CHANGES) return;
    nanosPerByte = Math.max(FASTEST, nanosPerByte * 0.95);
  }
}

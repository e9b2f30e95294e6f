package org.urbi.kernel.job;

import org.urbi.kernel.time.Clock;

/** A clock that shows what it is told, be it a simulated time or one that passes by itself. */
final class ManualClock implements Clock {
  private final boolean real;

  /** Nanoseconds. */
  long now;

  /** By how much each look at the clock moves it, in nanoseconds. */
  long step;

  private ManualClock(boolean real) {
    this.real = real;
  }

  static ManualClock real() {
    return new ManualClock(true);
  }

  static ManualClock simulated() {
    return new ManualClock(false);
  }

  @Override
  public long now() {
    return now += step;
  }

  @Override
  public double startTime() {
    return 0;
  }

  @Override
  public boolean isReal() {
    return real;
  }

  @Override
  public void advanceTo(long nanoseconds) {
    if (!real) {
      now = Math.max(now, nanoseconds);
    }
  }
}

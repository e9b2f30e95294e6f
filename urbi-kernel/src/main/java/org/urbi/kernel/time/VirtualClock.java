package org.urbi.kernel.time;

/**
 * Simulated time (option {@code --fast}): it stands still while jobs run, and jumps to the next
 * deadline when none can, so that a run depends on its input alone.
 */
public final class VirtualClock implements Clock {
  /** 2010-01-01, so that dates look like dates and never change from one run to the other. */
  private static final double START_TIME = 1_262_304_000.0;

  private long now;

  @Override
  public long now() {
    return now;
  }

  @Override
  public double startTime() {
    return START_TIME;
  }

  @Override
  public boolean isReal() {
    return false;
  }

  @Override
  public void advanceTo(long nanoseconds) {
    now = Math.max(now, nanoseconds);
  }
}

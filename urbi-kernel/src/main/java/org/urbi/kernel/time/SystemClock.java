package org.urbi.kernel.time;

/** The time of the machine, which never goes back. */
public final class SystemClock implements Clock {
  private final long origin = System.nanoTime();
  private final double startTime = System.currentTimeMillis() / 1000.0;

  @Override
  public long now() {
    return System.nanoTime() - origin;
  }

  @Override
  public double startTime() {
    return startTime;
  }

  @Override
  public boolean isReal() {
    return true;
  }

  @Override
  public void advanceTo(long nanoseconds) {}
}

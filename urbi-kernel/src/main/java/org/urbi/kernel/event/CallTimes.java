package org.urbi.kernel.event;

/** How often something was called, and how long that took, in nanoseconds. */
public final class CallTimes {
  private long count;
  private long total;
  private long least = Long.MAX_VALUE;
  private long most;

  /** One more call. */
  public void add(long nanoseconds) {
    count++;
    total += nanoseconds;
    least = Math.min(least, nanoseconds);
    most = Math.max(most, nanoseconds);
  }

  /** Forgets them all. */
  public void reset() {
    count = 0;
    total = 0;
    least = Long.MAX_VALUE;
    most = 0;
  }

  public long count() {
    return count;
  }

  /** The average in seconds; 0 without a call. */
  public double mean() {
    return count == 0 ? 0 : total / 1e9 / count;
  }

  /** The shortest in seconds; 0 without a call. */
  public double least() {
    return count == 0 ? 0 : least / 1e9;
  }

  /** The longest in seconds. */
  public double most() {
    return most / 1e9;
  }
}

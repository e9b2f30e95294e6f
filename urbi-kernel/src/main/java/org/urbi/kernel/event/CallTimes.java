package org.urbi.kernel.event;

/** How often something was called, and how long that took where it was measured, in nanoseconds. */
public final class CallTimes {
  private long count;
  private long measured;
  private long total;
  private long least = Long.MAX_VALUE;
  private long most;

  /** Counts a call that was not measured. */
  public void addUnmeasured() {
    count++;
  }

  /** One more call. */
  public void add(long nanoseconds) {
    count++;
    measured++;
    total += nanoseconds;
    least = Math.min(least, nanoseconds);
    most = Math.max(most, nanoseconds);
  }

  /** Forgets them all. */
  public void reset() {
    count = 0;
    measured = 0;
    total = 0;
    least = Long.MAX_VALUE;
    most = 0;
  }

  public long count() {
    return count;
  }

  /** The average in seconds of those that were measured; 0 without one. */
  public double mean() {
    return measured == 0 ? 0 : total / 1e9 / measured;
  }

  /** The shortest in seconds; 0 without one. */
  public double least() {
    return measured == 0 ? 0 : least / 1e9;
  }

  /** The longest in seconds. */
  public double most() {
    return most / 1e9;
  }
}

package org.urbi.kernel.job;

/** How long the ticks of a kernel take (manual, "System", {@code stats}); in seconds. */
public final class CycleStatistics {
  private static final double NANOSECONDS = 1e9;

  private long since;
  private long count;
  private double minimum;
  private double maximum;
  private double mean;
  private double squares;

  /**
   * Forgets all the ticks.
   *
   * @param cycle the number of the one that is going on
   */
  public void reset(long cycle) {
    since = cycle;
    count = 0;
    minimum = 0;
    maximum = 0;
    mean = 0;
    squares = 0;
  }

  /** A tick took so many nanoseconds. */
  void add(long nanoseconds) {
    double seconds = nanoseconds / NANOSECONDS;
    minimum = count == 0 ? seconds : Math.min(minimum, seconds);
    maximum = count == 0 ? seconds : Math.max(maximum, seconds);
    count++;
    double difference = seconds - mean;
    mean += difference / count;
    squares += difference * (seconds - mean);
  }

  /** The number of the first cycle that was not counted. */
  public long since() {
    return since;
  }

  public double minimum() {
    return minimum;
  }

  public double maximum() {
    return maximum;
  }

  /** The mean, not less than the minimum nor more than the maximum. */
  public double mean() {
    return Math.clamp(mean, minimum, maximum);
  }

  public double variance() {
    return count == 0 ? 0 : squares / count;
  }
}

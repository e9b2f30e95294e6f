package org.urbi.kernel.event;

/** How often something has happened, and when last. */
public final class Occurrences {
  private long times;
  private long last = -1;

  /**
   * Counts one time that it has happened.
   *
   * @param now in nanoseconds of the scheduler
   */
  public void note(long now) {
    times++;
    last = now;
  }

  /** How often it has happened. */
  public long times() {
    return times;
  }

  /** When it has happened last, in nanoseconds of the scheduler; negative if never. */
  public long last() {
    return last;
  }
}

package org.urbi.kernel.job;

/**
 * Counts the {@code ;} of a job that is alone, between two looks at the clock. Where a {@code ;} is
 * a matter of nanoseconds there are many of them between two looks; where the code between them
 * takes long, the clock is looked at each time, or timers would be late.
 */
final class YieldCount {
  /** The most of them between two looks. */
  private static final int MOST = 100;

  /** How long is to pass between two looks, in nanoseconds. */
  private static final long LOOK_PERIOD = 20_000;

  /** How long there may be no tick at all, in nanoseconds. */
  private static final long LONGEST_TURN = 1_000_000;

  private int count;
  private int most = MOST;
  private long looked;
  private long ticked;

  /** How many there have been since the last look. */
  int count() {
    return count;
  }

  /** Counts one; returns whether it is time for a look. */
  boolean isOver() {
    return ++count >= most;
  }

  /** The job has had its look, or others run. */
  void reset() {
    count = 0;
  }

  /** A tick begins at this time. */
  void beginTick(long now) {
    looked = now;
    ticked = now;
  }

  /** The job looks at the clock; returns whether there must be a tick, whatever is to be done. */
  boolean look(long now) {
    long period = Math.max(1, now - looked);
    most = Math.clamp(count * LOOK_PERIOD / period, 1, MOST);
    looked = now;
    return now - ticked >= LONGEST_TURN;
  }
}

package org.urbi.kernel.library.object;

import org.urbi.kernel.time.Clock;

/**
 * How often all garbage may be collected for one lobby although others have something to do, who
 * must wait for it: some times in a row, and then for a ten thousandth of the time, so that of a
 * thousand periods of a control loop none is late for that.
 */
final class CollectionPace {
  /** How long collections may take in a row, in nanoseconds, when there was none for long. */
  private static final long MOST = 100_000_000;

  /** For one part of so many there may be collections. */
  private static final int PARTS = 10_000;

  private final Clock machine;
  private long left = MOST;
  private long since;

  /**
   * @param machine the time that collections take
   */
  CollectionPace(Clock machine) {
    this.machine = machine;
    since = machine.now();
  }

  /** Whether there may be one now. */
  boolean allows() {
    long now = machine.now();
    left = Math.min(MOST, left + (now - since) / PARTS);
    since = now;
    return left > 0;
  }

  /** Makes one, for which others wait. */
  void measure(Runnable collection) {
    long began = machine.now();
    collection.run();
    left -= machine.now() - began;
  }
}

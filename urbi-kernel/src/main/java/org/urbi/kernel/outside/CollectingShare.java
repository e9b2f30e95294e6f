package org.urbi.kernel.outside;

/**
 * Whether a program collects garbage for more than some share of the time. A single collection
 * tells nothing: it may have all of the time for itself, and takes seconds on a busy machine.
 */
final class CollectingShare {
  /** The period over which that share is measured, at least, in nanoseconds. */
  private static final long PERIOD = 2_000_000_000;

  /** How many collections there are in a period, at least. */
  private static final int SEVERAL = 3;

  private final double most;
  private boolean measuring;
  private long began;
  private long before;
  private long countBefore;
  private boolean tooMuch;

  /**
   * @param most the share of the time that garbage collection may take
   */
  CollectingShare(double most) {
    this.most = most;
  }

  /**
   * To be called several times a second.
   *
   * @param now the time in nanoseconds
   * @param collecting how long the program has stood still so far, in nanoseconds
   * @param count how many collections there were so far
   */
  boolean isTooMuch(long now, long collecting, long count) {
    if (!measuring) {
      begin(now, collecting, count);
    } else if (now - began > PERIOD && count - countBefore >= SEVERAL) {
      tooMuch = collecting - before > most * (now - began);
      begin(now, collecting, count);
    }
    return tooMuch;
  }

  private void begin(long now, long collecting, long count) {
    measuring = true;
    began = now;
    before = collecting;
    countBefore = count;
  }

  /** Begins anew. */
  void forget() {
    measuring = false;
    tooMuch = false;
  }
}

package org.urbi.kernel.job;

/** Ends what many jobs execute: goes from one scope, handler or job to the next. */
abstract class Stop {
  private int number;

  /** The stop is done in several pieces from now on; given its place among such stops. */
  void beginPieces(int given) {
    number = given;
  }

  /** The last of the pieces has been done. */
  void endPieces() {}

  /** The place of this stop among those that are done in pieces; 0 if it is done at once. */
  final int number() {
    return number;
  }

  /**
   * Goes on.
   *
   * @param steps how much it may look at
   * @return whether it is over
   */
  final boolean goOn(int steps) {
    for (int step = 0; step < steps; step++) {
      if (!step()) {
        return true;
      }
    }
    return false;
  }

  /** Goes on to the next scope, handler or job; returns false if there was nothing left to do. */
  abstract boolean step();

  /** The stop has come to that job, which is to end. */
  final void end(Job job) {
    if (number == 0) {
      reach(job);
    } else {
      job.meetStops();
    }
  }

  /** Ends what that job executes, if that is to end. */
  abstract void reach(Job job);
}

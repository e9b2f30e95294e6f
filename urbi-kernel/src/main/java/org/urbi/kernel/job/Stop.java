package org.urbi.kernel.job;

/** The end of what many jobs do, on its way to them. */
abstract class Stop {
  private int number;

  /** It is made in pieces, and has a place among those that are. */
  void beginPieces(int given) {
    number = given;
  }

  /** The pieces are over. */
  void endPieces() {}

  /** Its place among those that are made in pieces; 0 if it is not. */
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

  /** It is the turn of that job to be ended. */
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

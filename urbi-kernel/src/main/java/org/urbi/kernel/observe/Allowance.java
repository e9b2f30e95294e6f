package org.urbi.kernel.observe;

/**
 * What one look may still do, in steps of about as long as it takes to see that a job has not
 * changed: the jobs of the kernel wait meanwhile.
 */
final class Allowance {
  /** A fraction of a millisecond, also on a slow machine. */
  private static final int ALL = 1000;

  /** What it takes to tell of a job. */
  static final int JOB = 5;

  /** What it takes to tell of a reaction, an event or a slot. */
  static final int ROW = 10;

  private int left = ALL;

  /** Whether there is something left. */
  boolean isLeft() {
    return left > 0;
  }

  /** Something has been done. */
  void use(int steps) {
    left -= steps;
  }
}

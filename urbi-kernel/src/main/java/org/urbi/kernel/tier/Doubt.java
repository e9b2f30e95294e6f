package org.urbi.kernel.tier;

/**
 * Makes compiled code take the slow path every so often, for tests: that must make no difference.
 */
final class Doubt {
  private final int period;
  private int count;

  Doubt(int period) {
    this.period = period;
  }

  /** Whether the next number is not taken for one, or the next version is forgotten. */
  boolean strikes() {
    count = (count + 1) % period;
    return count == 0;
  }
}

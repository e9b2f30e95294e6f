package org.urbi.kernel.time;

/**
 * The random numbers of one kernel. They follow from the seed alone, which is always the same one
 * until somebody sets another: so that runs can be repeated.
 */
public final class RandomNumbers {
  private long state;

  /** Starts the sequence that belongs to a seed. */
  public void seed(long seed) {
    state = seed;
  }

  /** The next integer from 0 to a bound, which it is always less than. */
  public double below(double bound) {
    return Math.floor((next() >>> 11) * 0x1p-53 * bound);
  }

  // The generator "SplitMix64" of Steele, Lea and Flood.
  private long next() {
    state += 0x9E3779B97F4A7C15L;
    long z = state;
    z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
    z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
    return z ^ z >>> 31;
  }
}

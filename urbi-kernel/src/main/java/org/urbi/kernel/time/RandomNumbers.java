package org.urbi.kernel.time;

/**
 * The random numbers of one kernel. They depend only on the seed, which is the same in each run
 * until a program sets another, so that runs can be repeated.
 */
public final class RandomNumbers {
  private long state;

  /** Starts the sequence that belongs to a seed. */
  public void seed(long seed) {
    state = seed;
  }

  /** The next integer that is at least 0 and less than the bound. */
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

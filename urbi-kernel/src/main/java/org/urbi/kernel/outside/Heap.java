package org.urbi.kernel.outside;

/** How full the heap is, with all garbage that nobody has collected yet. */
public interface Heap {
  /** Whether so much memory is used that it may soon be nearly full. */
  boolean isScarce();

  /**
   * Whether garbage collection leaves nearly no room, or takes nearly all of the time. Call this
   * several times a second while memory is scarce.
   *
   * @param now the time in nanoseconds
   */
  boolean isNearlyFull(long now);

  /** Resets the measurement: memory is no longer scarce. */
  void forget();

  /** How many times all garbage has been collected so far. */
  long collections();

  /** How long the program has stood still so far while garbage was collected, in nanoseconds. */
  long collecting();

  /** Collects garbage, which nobody else would do soon. */
  void collect();

  /** Keeps a little memory for later, unless some is kept already. */
  void keepReserve();

  /** Gives back what was kept: others may have taken all the rest. */
  void releaseReserve();
}

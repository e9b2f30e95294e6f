package org.urbi.kernel.outside;

/** How full the heap is, with all garbage that nobody has collected yet. */
public interface Heap {
  /** Whether so much memory is used that it may soon be nearly full. */
  boolean isScarce();

  /**
   * Whether garbage collection leaves nearly no room, or takes nearly all of the time, or much of
   * it where it leaves little room. Call this several times a second while memory is scarce.
   *
   * @param now the time in nanoseconds
   */
  boolean isNearlyFull(long now);

  /**
   * Whether nearly no room is left, garbage included: what is asked when that has just been
   * collected for somebody who got no memory. It takes none.
   */
  boolean isExhausted();

  /** Resets the measurement: memory is no longer scarce. */
  void forget();

  /**
   * Somebody has been asked to give back memory: whether collections take too much of the time for
   * the little that they leave is measured anew.
   */
  void expectRelief();

  /** How many times all garbage has been collected so far. */
  long collections();

  /** How long the program has stood still so far while garbage was collected, in nanoseconds. */
  long collecting();

  /** Collects garbage, which nobody else would do soon. */
  void collect();

  /** Keeps a little memory for later, several times, unless it is kept already. */
  void keepReserve();

  /** Gives back one part of what was kept: others may have taken all the rest. */
  void releaseReserve();
}

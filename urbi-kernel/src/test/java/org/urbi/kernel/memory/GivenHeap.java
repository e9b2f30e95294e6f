package org.urbi.kernel.memory;

import org.urbi.kernel.outside.Heap;

/** A heap that is as full as a test says. */
final class GivenHeap implements Heap {
  boolean full;

  /**
   * Whether it only seems full until somebody has been asked, by the time that collections took.
   */
  boolean slow;

  /** Whether it may soon be full again, if it is not. */
  boolean scarce;

  long collecting;
  int collections;

  /** Whether looking takes memory that there is not, except for so many times. */
  boolean exhausted;

  int free;
  boolean reserved;

  /** Says what becomes of the heap when garbage is collected. */
  Runnable whenCollected = () -> {};

  @Override
  public boolean isScarce() {
    return full || scarce || slow;
  }

  @Override
  public boolean isNearlyFull(long now) {
    return full || slow;
  }

  @Override
  public void expectRelief() {
    slow = false;
  }

  @Override
  public boolean isExhausted() {
    return full;
  }

  @Override
  public void forget() {}

  @Override
  public void keepReserve() {
    reserved = true;
  }

  @Override
  public void releaseReserve() {
    if (reserved) {
      reserved = false;
      free += 3;
    }
  }

  @Override
  public long collections() {
    if (exhausted && free-- <= 0) {
      throw new OutOfMemoryError();
    }
    return collections;
  }

  @Override
  public long collecting() {
    return collecting;
  }

  @Override
  public void collect() {
    collections++;
    whenCollected.run();
  }
}

package org.urbi.kernel.memory;

import org.urbi.kernel.outside.Heap;

/** A heap that is as full as a test says. */
final class GivenHeap implements Heap {
  boolean full;
  long collecting;
  int collections;

  /** Says what becomes of the heap when garbage is collected. */
  Runnable whenCollected = () -> {};

  @Override
  public boolean isScarce() {
    return full;
  }

  @Override
  public boolean isNearlyFull(long now) {
    return full;
  }

  @Override
  public void forget() {}

  @Override
  public long collections() {
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

package org.urbi.ros.rtps;

/** Bytes that several may take from, never more than there are. */
final class MemoryBudget {
  private long left;

  MemoryBudget(long bytes) {
    left = bytes;
  }

  /** Whether so many were left, and are taken now. */
  boolean take(long bytes) {
    if (bytes > left) return false;
    left -= bytes;
    return true;
  }

  void giveBack(long bytes) {
    left += bytes;
  }

  long left() {
    return left;
  }
}

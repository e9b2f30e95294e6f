package org.urbi.kernel.job;

import java.util.function.LongSupplier;

/**
 * Stops the kernel thread before it fills the memory, until somebody has looked how much of that is
 * garbage. Whoever looks only now and then is too late: a loop fills hundreds of megabytes between
 * two looks. Once the memory is full, each allocation has all garbage collected, and nobody gets on
 * with freeing some.
 *
 * <p>After each measurement the thread may allocate half of what is free: the less that is, the
 * more often it measures. What runs and in which order does not depend on it, so it is in no
 * recording.
 */
public final class MemoryGate {
  /**
   * Memory is scarce when less than this fraction of it, an eighth, is free: then it must be known
   * what is garbage.
   */
  private static final int SCARCE_PART = 8;

  /** This fraction of the memory, a 64th, may always be allocated before the next measurement. */
  private static final int LEAST_PART = 64;

  /** How long ticks may follow each other before the next measurement, in nanoseconds. */
  private static final long PERIOD = 4_000_000;

  private final LongSupplier allocated;
  private final MemoryWait memory;
  private LongSupplier free = () -> Long.MAX_VALUE;
  private long all = Long.MAX_VALUE;
  private volatile boolean armed;
  private long ticked;
  private long before;
  private long room;

  /**
   * @param allocated how many bytes the kernel thread has allocated
   */
  MemoryGate(LongSupplier allocated, MemoryWait memory) {
    this.allocated = allocated;
    this.memory = memory;
  }

  /**
   * Sets what the memory is. To be called before the kernel starts.
   *
   * @param free how many bytes are free; what garbage takes is not
   * @param all how many bytes there are
   */
  public void setMemory(LongSupplier free, long all) {
    this.free = free;
    this.all = all;
  }

  /** From now on it measures, which would delay the start of a kernel; from any thread. */
  public void arm() {
    armed = true;
  }

  /**
   * A tick begins at that time of the machine: simulated time does not tell what it has done.
   *
   * @return whether it may have waited
   */
  boolean tick(long now) {
    boolean due = armed && now - ticked >= PERIOD;
    if (due) {
      ticked = now;
      pass();
    }
    return due;
  }

  /** How many bytes may still be allocated before the next {@link #pass}. */
  long room(long allocatedNow) {
    return armed ? Math.max(0, room - (allocatedNow - before)) : Long.MAX_VALUE;
  }

  /** Waits for a look if too much has been allocated since the last one. */
  void pass() {
    if (armed && allocated.getAsLong() - before >= room) {
      long left = free.getAsLong();
      if (left < all / SCARCE_PART) {
        memory.look();
        left = free.getAsLong();
      }
      before = allocated.getAsLong();
      room = Math.max(left / 2, all / LEAST_PART);
    }
  }
}

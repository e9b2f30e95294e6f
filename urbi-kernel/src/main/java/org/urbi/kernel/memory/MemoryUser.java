package org.urbi.kernel.memory;

/**
 * A kernel, as far as the memory of its process is concerned. The methods are called on the thread
 * of the {@link MemoryWatchdog}; when memory is exhausted they can make nothing.
 */
public interface MemoryUser {
  /** Loads what it needs when there is no memory to load it; once for all kernels. */
  void prepare();

  /**
   * Says whether memory is scarce; several times a second. While it is, the growth of lobbies is
   * measured.
   */
  void memoryScarce(boolean scarce);

  /**
   * How much the one has grown whom {@link #relieve} would end, in bytes; infinite if it only
   * completes what it has begun, 0 if there is nobody.
   */
  double growth();

  /**
   * Ends what the lobby does that has grown most, or lets its client go if that was done before.
   */
  void relieve();

  /**
   * Whether what {@link #relieve} last began has been done, so that the next collection of garbage
   * tells how much it has freed.
   */
  boolean isDone();

  /** Says that memory is nearly exhausted, or that it is not any more. */
  void memoryNearlyFull(boolean full);

  /** Memory could not be freed. */
  void memoryExhausted();
}

package org.urbi.ros.rtps;

import org.urbi.ros.time.SteadyClock;

/**
 * How much is on its way to reliable readers before they have acknowledged anything of it. It grows
 * as long as nothing is lost, as that of TCP does.
 */
final class Window {
  private static final long SMALLEST = 32 << 10;
  private static final long LARGEST = 1 << 20;
  private static final long STEP = 2 << 10;
  private static final long BETWEEN_CHANGES = 5_000_000;

  /** What the buffers of a system take for a datagram beside its bytes, about. */
  private static final int PER_DATAGRAM = 1300;

  private long bytes = 128 << 10;
  private long shrunk = SteadyClock.nanoseconds();

  /** How many samples of that size may be on their way. */
  int samples(int size) {
    return (int) Math.max(1, bytes / (size + PER_DATAGRAM));
  }

  void grow() {
    bytes = Math.min(LARGEST, bytes + STEP);
  }

  void shrink(long now) {
    if (now - shrunk < BETWEEN_CHANGES) return;
    shrunk = now;
    bytes = Math.max(SMALLEST, bytes / 4 * 3);
  }
}

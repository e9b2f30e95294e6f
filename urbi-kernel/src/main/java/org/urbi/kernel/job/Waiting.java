package org.urbi.kernel.job;

import java.io.IOException;

/** A way to wait that can be ended by another thread. */
public interface Waiting {
  /**
   * Waits for at most so many milliseconds; not at all if it was woken since the last time.
   *
   * @throws IOException if it cannot wait
   */
  void await(long milliseconds) throws IOException;

  /** Ends the waiting; from any thread. */
  void wake();
}

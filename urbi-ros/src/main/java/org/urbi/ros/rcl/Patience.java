package org.urbi.ros.rcl;

import java.time.Duration;

/**
 * Waits at the end for what may hang in the middleware: after a while it says so, and in the end it
 * gives up, because somebody else waits for it in turn.
 *
 * @param silent for how long nothing is said
 * @param limit for how long it waits in all
 */
record Patience(Duration silent, Duration limit) {
  static final Patience USUAL = new Patience(Duration.ofSeconds(1), Duration.ofSeconds(5));

  /** What is waited for. */
  @FunctionalInterface
  interface Awaited {
    /** Whether it comes within that time. */
    boolean comesWithin(Duration time) throws InterruptedException;
  }

  /**
   * Waits.
   *
   * @param waits is called if it takes so long that people should know
   * @return whether it has come
   */
  boolean await(Awaited what, Runnable waits) throws InterruptedException {
    if (what.comesWithin(silent)) return true;
    waits.run();
    return what.comesWithin(limit.minus(silent));
  }
}

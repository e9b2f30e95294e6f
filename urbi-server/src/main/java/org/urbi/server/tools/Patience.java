package org.urbi.server.tools;

import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.urbi.kernel.time.Clock;

/**
 * Tries something again until it works or a time is over: nobody tells a program when a server of
 * another process will have begun to listen.
 */
final class Patience {
  private static final long PAUSE = TimeUnit.MILLISECONDS.toNanos(50);

  /** How the time passes until the next try; the argument is in nanoseconds. */
  interface Pause {
    void last(long nanoseconds) throws InterruptedException;
  }

  private final Clock clock;
  private final Pause pause;
  private final long end;

  /**
   * @param duration for how long; zero for a single try
   */
  Patience(Clock clock, Pause pause, Duration duration) {
    this.clock = clock;
    this.pause = pause;
    this.end = clock.now() + duration.toNanos();
  }

  /** Whether to try once more; waits a moment before. The last try is when the time is over. */
  boolean again() {
    long left = end - clock.now();
    if (left <= 0) {
      return false;
    }
    try {
      pause.last(Math.min(left, PAUSE));
      return true;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }
}

package org.urbi.ros.time;

import java.time.Instant;
import java.util.concurrent.TimeUnit;

/**
 * What time it is for people, as messages are stamped with it. It may jump; nothing waits by it.
 */
public final class WallClock {
  private WallClock() {}

  /** Nanoseconds since 1970. */
  public static long nanoseconds() {
    Instant now = Instant.now();
    return TimeUnit.SECONDS.toNanos(now.getEpochSecond()) + now.getNano();
  }
}

package org.urbi.ros.uobject;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.time.SteadyClock;

/**
 * Has something done at once when it is wanted, but not more often than at a rate: what is wanted
 * too early is done when its time has come, once, however often it was wanted.
 */
final class Pace {
  private static final double NANOSECONDS = 1e9;

  private final Runnable task;
  private final long period;
  private long next;
  private boolean begun;
  private boolean waiting;

  /**
   * @param rate how often in a second at most; 0 for as often as it is wanted
   * @param task does not wait, and throws nothing
   * @throws RosException if the rate is no such number
   */
  Pace(double rate, Runnable task) {
    if (!(rate >= 0)) {
      throw new RosException("rate: times a second expected, or 0 for no limit, not " + rate);
    }
    this.task = task;
    period = rate == 0 ? 0 : (long) Math.min(NANOSECONDS / rate, Long.MAX_VALUE / 4.0);
  }

  void want() {
    synchronized (this) {
      if (waiting) {
        return;
      }
      long now = SteadyClock.nanoseconds();
      long wait = next - now;
      if (begun && wait > 0) {
        waiting = true;
        CompletableFuture.delayedExecutor(wait, TimeUnit.NANOSECONDS).execute(this::due);
        return;
      }
      begun = true;
      next = now + period;
    }
    task.run();
  }

  private void due() {
    synchronized (this) {
      waiting = false;
      next = SteadyClock.nanoseconds() + period;
    }
    task.run();
  }
}

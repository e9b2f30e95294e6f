package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;

/**
 * How a simulated time passes while something real goes on: a process runs, a connection is open.
 * What answers soon takes no time at all. While nothing is heard, the simulated time goes at the
 * pace of the machine's, so that whoever waits with a deadline does not wait for ever.
 */
public final class Pace {
  /** What is over sooner, in nanoseconds, takes no simulated time. */
  private static final long GRACE = 100_000_000;

  private final Clock machine = new SystemClock();
  private final List<BooleanSupplier> conditions = new ArrayList<>();
  private int activities;
  private long debt;

  /** Something real begins; on the kernel thread. */
  public void begin() {
    activities++;
  }

  /** Something real is over; on the kernel thread. */
  public void end() {
    activities--;
  }

  /** Something real goes on whenever that holds. */
  public void beginWhile(BooleanSupplier condition) {
    conditions.add(condition);
  }

  boolean isReal() {
    if (activities > 0 || conditions.stream().anyMatch(BooleanSupplier::getAsBoolean)) {
      return true;
    }
    debt = 0;
    return false;
  }

  /** Waits for news, or for the next deadline, and moves the simulated time accordingly. */
  void idle(Inbox inbox, Clock simulated, long next) {
    long now = simulated.now();
    long from = machine.now();
    inbox.await(next == Long.MAX_VALUE ? next : Math.max(0, next - now - debt));
    debt += machine.now() - from;
    if (debt >= GRACE || !inbox.isFilled()) {
      simulated.advanceTo(Math.min(next, now + debt));
      debt = 0;
    }
  }
}

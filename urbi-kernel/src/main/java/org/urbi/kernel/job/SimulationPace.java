package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.urbi.kernel.time.Clock;

/**
 * How a simulated time passes while something real goes on: a process runs, a connection is open.
 * What answers soon takes no time at all. While nothing is heard, the simulated time goes at the
 * pace of the machine's, so that whoever waits with a deadline does not wait for ever.
 */
public final class SimulationPace {
  /** What is over sooner, in nanoseconds, takes no simulated time. */
  private static final long GRACE = 100_000_000;

  private final Clock simulated;
  private final Clock machine;
  private final List<BooleanSupplier> conditions = new ArrayList<>();
  private int activities;
  private boolean real;

  /** How far the machine's time is ahead of the simulated one as long as they go together. */
  private long offset;

  SimulationPace(Clock simulated, Clock machine) {
    this.simulated = simulated;
    this.machine = machine;
  }

  /** Something real begins; on the kernel thread. */
  public void begin() {
    activities++;
    follow();
  }

  /** Something real is over; on the kernel thread. */
  public void end() {
    activities--;
  }

  /** Something real goes on whenever that holds. */
  public void beginWhile(BooleanSupplier condition) {
    conditions.add(condition);
  }

  private void follow() {
    if (!real) {
      real = true;
      offset = machine.now() - simulated.now();
    }
  }

  boolean isReal() {
    if (activities > 0 || conditions.stream().anyMatch(BooleanSupplier::getAsBoolean)) {
      follow();
    } else {
      real = false;
    }
    return real;
  }

  /** Waits for news, or for the next deadline, and moves the simulated time accordingly. */
  void idle(Inbox inbox, long next) {
    long now = simulated.now();
    // Who has run ahead of the machine does not wait for it.
    offset = Math.min(offset, machine.now() - now);
    inbox.await(next == Long.MAX_VALUE ? next : Math.max(0, next + offset - machine.now()));
    long due = machine.now() - offset;
    if (due - now >= GRACE || !inbox.isFilled()) {
      simulated.advanceTo(Math.min(next, due));
    }
  }
}

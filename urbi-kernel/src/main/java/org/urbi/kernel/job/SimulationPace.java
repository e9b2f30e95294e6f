package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.urbi.kernel.time.Clock;

/**
 * Controls how simulated time passes while real activities go on: a process runs, a connection is
 * open. An answer that comes soon takes no simulated time. While no message arrives, simulated time
 * runs at the pace of real time, so that deadlines are reached.
 */
public final class SimulationPace {
  /** Activities shorter than this, in nanoseconds, take no simulated time. */
  private static final long GRACE = 100_000_000;

  private final Clock simulated;
  private final Clock machine;
  private final List<BooleanSupplier> conditions = new ArrayList<>();
  private int activities;
  private boolean real;

  /** The difference between real and simulated time while both run at the same pace. */
  private long offset;

  SimulationPace(Clock simulated, Clock machine) {
    this.simulated = simulated;
    this.machine = machine;
  }

  /** A real activity begins; on the kernel thread. */
  public void begin() {
    activities++;
    follow();
  }

  /** A real activity has ended; on the kernel thread. */
  public void end() {
    activities--;
  }

  /** Adds a condition: while it is true, a real activity goes on. */
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

  /** Waits for a message, or for the next deadline, and moves simulated time accordingly. */
  void idle(Inbox inbox, long next) {
    long now = simulated.now();
    // If simulated time is ahead of real time, do not wait for real time to catch up.
    offset = Math.min(offset, machine.now() - now);
    inbox.await(next == Long.MAX_VALUE ? next : Math.max(0, next + offset - machine.now()));
    long due = machine.now() - offset;
    if (due - now >= GRACE || !inbox.isFilled()) {
      simulated.advanceTo(Math.min(next, due));
    }
  }
}

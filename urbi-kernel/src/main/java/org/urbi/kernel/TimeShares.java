package org.urbi.kernel;

import java.util.Collection;
import java.util.Map;
import java.util.WeakHashMap;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Meter;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;

/** Looks, each second, whether lobbies take more of the kernel's time than they may. */
final class TimeShares {
  private static final long WINDOW_MILLISECONDS = 1000;

  private static final double PERCENT = 100;

  private final Clock clock = new SystemClock();
  private final Meter meter;
  private final Collection<KernelConnection> connections;
  private volatile boolean over;
  private final Map<Budget, Long> before = new WeakHashMap<>();

  /**
   * @param connections all there are, at any time
   */
  TimeShares(Meter meter, Collection<KernelConnection> connections) {
    this.meter = meter;
    this.connections = connections;
  }

  void start() {
    meter.begin();
    Thread.ofPlatform().daemon().name("urbi-shares").start(this::watch);
  }

  /** There is nobody left to look after. */
  void stop() {
    over = true;
  }

  private void watch() {
    long since = clock.now();
    while (!over) {
      try {
        Thread.sleep(WINDOW_MILLISECONDS);
      } catch (InterruptedException e) {
        return;
      }
      long now = clock.now();
      for (KernelConnection each : connections) {
        look(each, now - since);
      }
      since = now;
    }
  }

  private void look(KernelConnection connection, long window) {
    Budget budget = connection.lobby().budget();
    long most = budget.limit(Resource.TIME);
    long taken = meter.nanoseconds(budget);
    Long known = before.put(budget, taken);
    if (known != null && taken - known > window / PERCENT * most) {
      connection.evict(Problem.BUDGET_EXHAUSTED.text(most, Resource.TIME.unit()));
    }
  }
}

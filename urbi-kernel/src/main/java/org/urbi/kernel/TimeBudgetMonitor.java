package org.urbi.kernel;

import java.util.Collection;
import java.util.Map;
import java.util.WeakHashMap;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.UsageMeter;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;

/** Checks each second whether a lobby uses more of the kernel's time than its budget allows. */
final class TimeBudgetMonitor {
  private static final long WINDOW_MILLISECONDS = 1000;

  private static final double PERCENT = 100;

  private final Clock clock = new SystemClock();
  private final UsageMeter meter;
  private final Collection<KernelConnection> connections;
  private volatile boolean over;
  private final Map<Budget, Long> before = new WeakHashMap<>();

  /**
   * @param connections all there are, at any time
   */
  TimeBudgetMonitor(UsageMeter meter, Collection<KernelConnection> connections) {
    this.meter = meter;
    this.connections = connections;
  }

  void start() {
    meter.begin();
    Thread.ofPlatform().daemon().name("urbi-shares").start(this::watch);
  }

  /** Ends the thread: no lobby has a time limit any more. */
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
      long window = now - since;
      for (KernelConnection each : connections) {
        FailureLog.guarding("the watch over budgets", () -> check(each, window)).run();
      }
      since = now;
    }
  }

  private void check(KernelConnection connection, long window) {
    Budget budget = connection.lobby().budget();
    long most = budget.limit(Resource.TIME);
    long taken = meter.nanoseconds(budget);
    Long known = before.put(budget, taken);
    if (known != null && taken - known > window / PERCENT * most) {
      connection.evict(Problem.BUDGET_EXHAUSTED.text(most, Resource.TIME.unit()));
    }
  }
}

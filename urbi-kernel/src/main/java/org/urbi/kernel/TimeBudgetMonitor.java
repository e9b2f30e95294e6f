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
  private final DepartedClients departed;
  private volatile boolean over;
  private final Map<Budget, Long> before = new WeakHashMap<>();

  /**
   * @param connections all there are, at any time
   */
  TimeBudgetMonitor(
      UsageMeter meter, Collection<KernelConnection> connections, DepartedClients departed) {
    this.meter = meter;
    this.connections = connections;
    this.departed = departed;
  }

  void start() {
    meter.begin();
    FailureLog.THREADS.platform("urbi-shares", this::watch).start();
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
        guarded(() -> check(each, window));
      }
      guarded(() -> checkLeftBehind(window));
      since = now;
    }
  }

  private static void guarded(Runnable check) {
    FailureLog.THREADS.guarding("the watch over budgets", check).run();
  }

  private void check(KernelConnection connection, long window) {
    long most = connection.budget().limit(Resource.TIME);
    if (takenOf(connection) > window / PERCENT * most) {
      connection.evict(Problem.BUDGET_EXHAUSTED.text(most, Resource.TIME.unit()));
    }
  }

  /** What clients who have left have left behind takes together as much as one client may. */
  private void checkLeftBehind(long window) {
    long most = departed.budget().limit(Resource.TIME);
    long all = 0;
    long largest = 0;
    KernelConnection culprit = null;
    for (KernelConnection each : departed.all()) {
      long taken = takenOf(each);
      all += taken;
      if (taken > largest) {
        largest = taken;
        culprit = each;
      }
    }
    if (culprit != null && all > window / PERCENT * most) {
      culprit.evict(Problem.COMMON_BUDGET.text(most, Resource.TIME.unit()));
    }
  }

  /** For how long its jobs have run since the last look, in nanoseconds. */
  private long takenOf(KernelConnection connection) {
    Budget budget = connection.budget();
    long taken = meter.nanoseconds(budget);
    Long known = before.put(budget, taken);
    return known == null ? 0 : taken - known;
  }
}

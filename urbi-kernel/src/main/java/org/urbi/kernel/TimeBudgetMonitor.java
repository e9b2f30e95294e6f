package org.urbi.kernel;

import java.util.Collection;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.concurrent.TimeUnit;
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
  private final Map<Budget, Look> before = new WeakHashMap<>();

  /** For how long jobs with a budget had run at some time, both in nanoseconds. */
  private record Look(long taken, long at) {}

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
    while (!over) {
      try {
        Thread.sleep(WINDOW_MILLISECONDS);
      } catch (InterruptedException e) {
        return;
      }
      long now = clock.now();
      for (KernelConnection each : connections) {
        guarded(() -> check(each, now));
      }
      guarded(() -> checkLeftBehind(now));
    }
  }

  private static void guarded(Runnable check) {
    FailureLog.THREADS.guarding("the watch over budgets", check).run();
  }

  private void check(KernelConnection connection, long now) {
    long most = connection.budget().limit(Resource.TIME);
    if (percentOf(connection, now) > most) {
      connection.evict(Problem.BUDGET_EXHAUSTED.text(most, Resource.TIME.unit()));
    }
  }

  /** What clients who have left have left behind takes together as much as one client may. */
  private void checkLeftBehind(long now) {
    long most = departed.budget().limit(Resource.TIME);
    double all = 0;
    double largest = 0;
    KernelConnection culprit = null;
    for (KernelConnection each : departed.all()) {
      double taken = percentOf(each, now);
      all += taken;
      if (taken > largest) {
        largest = taken;
        culprit = each;
      }
    }
    if (culprit != null && all > most) {
      culprit.evict(Problem.COMMON_BUDGET.text(most, Resource.TIME.unit()));
    }
  }

  /**
   * How much of the time its jobs have had since the last look at it. That may be long ago: who has
   * left is looked at only while jobs run for it.
   */
  private double percentOf(KernelConnection connection, long now) {
    Budget budget = connection.budget();
    long taken = meter.nanoseconds(budget);
    Look known = before.put(budget, new Look(taken, now));
    if (known == null) {
      return 0;
    }
    // Who is leaving may be looked at twice at a time.
    long window = Math.max(now - known.at, TimeUnit.MILLISECONDS.toNanos(WINDOW_MILLISECONDS));
    return PERCENT * (taken - known.taken) / window;
  }
}

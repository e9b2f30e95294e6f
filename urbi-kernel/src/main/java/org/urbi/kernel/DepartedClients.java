package org.urbi.kernel;

import java.lang.ref.WeakReference;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.time.RateLimit;

/**
 * Clients that have left while jobs of theirs go on: jobs that were detached from the connection,
 * and jobs that do not end with it. All these jobs together have the budget of one client, the one
 * that has left last. If they exceed it, the jobs of the client with most of them end; among
 * clients with equally many, those of the one that has left last.
 */
final class DepartedClients {
  /** How long jobs may take to end, in nanoseconds: until then they are not counted. */
  private static final long GRACE = 1_000_000_000;

  /**
   * How many lines in a second tell of what was ended: of those whose functions are called again
   * and again, it may be ended each time.
   */
  private static final int MOST_TOLD = 100;

  private final Kernel kernel;
  private final KernelLog log;
  private final RateLimit told = new RateLimit(MOST_TOLD);
  private final Budget common = new Budget();

  /** The clients whose jobs go on. */
  private final Map<KernelConnection, State> known = new ConcurrentHashMap<>();

  /** Clients whose jobs may still be ending, in the order in which they have left. */
  private final Queue<Leaving> leaving = new ArrayDeque<>();

  private boolean lookIsDue;

  /** A connection that has been left, if it has not become garbage, and when. */
  private record Leaving(WeakReference<KernelConnection> who, long since) {}

  private static final class State {
    /** From when on all its jobs count, even those that should have ended. */
    private long settled;

    /** Whether what it has left behind was asked to end. */
    private boolean ending;
  }

  DepartedClients(Kernel kernel, KernelLog log) {
    this.kernel = kernel;
    this.log = log;
    common.whenUseChanges(this::useChanged);
  }

  // ------------------------------------------------------------------ from any thread

  /** What all these jobs may have together. */
  Budget budget() {
    return common;
  }

  /** The connections of the clients whose jobs go on. */
  Collection<KernelConnection> all() {
    return known.keySet();
  }

  // ------------------------------------------------------------------ on the kernel thread

  boolean has(KernelConnection who) {
    return known.containsKey(who);
  }

  /** A client has left, and its lobby is closed. */
  void left(KernelConnection who) {
    long now = kernel.scheduler().now();
    if (who.lobby().hasDetached()) {
      adopt(who, now + GRACE);
    } else {
      leaving.add(new Leaving(new WeakReference<>(who), now));
      who.budget().whenUseChanges(() -> adoptIfBack(who, now + GRACE));
    }
    for (Leaving next = leaving.peek();
        next != null && now - next.since >= GRACE;
        next = leaving.peek()) {
      leaving.remove();
      KernelConnection lingering = next.who.get();
      if (lingering != null && lingering.budget().used(Resource.JOBS) > 0) {
        adopt(lingering, now);
      }
    }
  }

  /**
   * A function that it has left behind may be called at any time, as a hook on a variable is, in a
   * job: from then on it counts as if it had left that job.
   */
  private void adoptIfBack(KernelConnection who, long settled) {
    if (who.budget().used(Resource.JOBS) > 0 && kernel.scheduler().now() - settled >= 0) {
      adopt(who, settled);
    }
  }

  private void adopt(KernelConnection who, long settled) {
    if (known.containsKey(who)) {
      return;
    }
    State state = new State();
    state.settled = settled;
    known.put(who, state);
    who.remember();
    kernel.memory().add(who);
    Budget budget = who.budget();
    budget.whenUseChanges(() -> forgetIfOver(who));
    if (budget.account() != common) {
      common.setLimits(who.limits());
      budget.join(common);
    }
  }

  private void forgetIfOver(KernelConnection who) {
    if (who.budget().used(Resource.JOBS) == 0
        && !who.lobby().hasDetached()
        && known.remove(who) != null) {
      kernel.memory().remove(who);
      who.forget();
      long now = kernel.scheduler().now();
      who.budget().whenUseChanges(() -> adoptIfBack(who, now));
    }
  }

  private void useChanged() {
    if (!lookIsDue && common.used(Resource.JOBS) > common.limit(Resource.JOBS)) {
      lookIsDue = true;
      kernel.scheduler().atEndOfTick(this::endExcess);
    }
  }

  private void endExcess() {
    lookIsDue = false;
    long now = kernel.scheduler().now();
    long most = common.limit(Resource.JOBS);
    long jobs = 0;
    for (KernelConnection each : known.keySet()) {
      if (counts(each, now)) {
        jobs += each.budget().used(Resource.JOBS);
      }
    }
    while (jobs > most) {
      KernelConnection largest = largest(now);
      if (largest == null) {
        return;
      }
      jobs -= largest.budget().used(Resource.JOBS);
      end(largest, Problem.COMMON_BUDGET.text(most, Resource.JOBS.unit()));
    }
  }

  private @Nullable KernelConnection largest(long now) {
    KernelConnection largest = null;
    for (KernelConnection each : known.keySet()) {
      if (counts(each, now) && (largest == null || isLarger(each, largest))) {
        largest = each;
      }
    }
    return largest;
  }

  private static boolean isLarger(KernelConnection one, KernelConnection other) {
    long more = one.budget().used(Resource.JOBS) - other.budget().used(Resource.JOBS);
    // The numbers of connections descend.
    return more > 0 || more == 0 && one.number() < other.number();
  }

  private boolean counts(KernelConnection who, long now) {
    State state = known.get(who);
    return state != null && (now - state.settled >= 0 || !state.ending && who.lobby().hasEnded());
  }

  /** Ends what somebody has left behind, if there still is something, and says so. */
  void end(KernelConnection who, String reason) {
    State state = known.get(who);
    if (state == null) {
      return;
    }
    state.ending = true;
    long now = kernel.scheduler().now();
    state.settled = now + GRACE;
    if (log.shows(LogLevel.LOG) && told.take(now, 1)) {
      log.write(
          "urbi: "
              + Problem.LEFT_BEHIND.text(
                  reason, who.description(), who.budget().used(Resource.JOBS)));
    }
    kernel.lobbies().endAll(who.budget());
    who.lobby().endDetached(kernel.interpreter());
  }
}

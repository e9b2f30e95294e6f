package org.urbi.kernel;

import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.HoldWatchdog;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;

/**
 * Requests that other threads answer while a job holds the kernel, when the kernel's own thread
 * cannot.
 */
final class OutOfBandControl {
  /**
   * A job that has held the kernel for less than this, in nanoseconds, is not considered to hold
   * it.
   */
  private static final long SHORTEST_HOLD = 100_000_000;

  /** How many calls of a stack are shown. */
  private static final int MOST_CALLS = 40;

  private final Scheduler scheduler;
  private final DepartedClients departed;
  private final Map<String, KernelConnection> connections = new ConcurrentSkipListMap<>();
  private @Nullable TimeBudgetMonitor shares;
  private volatile @Nullable HoldWatchdog watch;

  OutOfBandControl(Scheduler scheduler, DepartedClients departed) {
    this.scheduler = scheduler;
    this.departed = departed;
  }

  void setWatch(@Nullable HoldWatchdog who) {
    watch = who;
  }

  /** Says whether memory is nearly exhausted: then nobody may hold the kernel for long. */
  void hurry(boolean is) {
    HoldWatchdog who = watch;
    if (who != null) {
      who.hurry(is);
    }
  }

  void add(KernelConnection connection) {
    connections.put(connection.lobby().name(), connection);
    HoldWatchdog who = watch;
    if (who != null && !connection.stays()) {
      who.watchHolds();
    }
  }

  void remove(KernelConnection connection) {
    connections.values().remove(connection);
  }

  /** Does what {@link Connection#interrupt(String)} promises. */
  String interrupt(String lobby) {
    return lobby.isEmpty() ? interruptHolder() : interruptLobby(lobby);
  }

  /** For how long a job has held the kernel, in nanoseconds. */
  long heldFor() {
    HoldWatchdog who = watch;
    if (who == null) {
      return 0;
    }
    who.watchHolds();
    return who.heldFor();
  }

  /** What holds the kernel, and where in Java it is, innermost call first. */
  String holder() {
    Job job = scheduler.running();
    if (job == null) {
      return Problem.NOBODY_HOLDS.text();
    }
    StringBuilder text = new StringBuilder(HoldLimit.described(job, job.component()));
    StackTraceElement[] calls = job.stackTrace();
    for (int i = 0; i < Math.min(calls.length, MOST_CALLS); i++) {
      text.append("\n    at ").append(calls[i]);
    }
    return text.toString();
  }

  /** The budget of a lobby has got a limit, which must perhaps be watched from now on. */
  void watchBudget(Resource what, long limit) {
    HoldWatchdog who = watch;
    if (what == Resource.HOLD && who != null) {
      who.watchBudget(TimeUnit.MILLISECONDS.toNanos(limit));
    } else if (what == Resource.MEMORY && who != null) {
      who.watchMemory();
    } else if (what == Resource.TIME && shares == null) {
      shares = new TimeBudgetMonitor(scheduler.meter(), connections.values(), departed);
      shares.start();
    }
  }

  /** The kernel has ended. */
  void end() {
    if (shares != null) {
      shares.stop();
    }
    HoldWatchdog who = watch;
    if (who != null) {
      who.end();
    }
  }

  private String interruptHolder() {
    HoldWatchdog who = watch;
    Job job = scheduler.running();
    long held = heldFor();
    if (who == null || held < SHORTEST_HOLD || job == null) {
      return Problem.NOBODY_HOLDS.text();
    }
    String told =
        Problem.INTERRUPTED_HOLDER.text(
            HoldLimit.described(job, job.component()), held / 100_000_000 / 10.0);
    who.interrupt();
    return told;
  }

  private String interruptLobby(String lobby) {
    KernelConnection connection = connections.get(lobby);
    if (connection == null) {
      return Problem.NO_SUCH_LOBBY.text(
          lobby,
          connections.values().stream()
              .map(each -> each.lobby().description())
              .collect(Collectors.joining(", ")));
    }
    connection.interrupt();
    return Problem.INTERRUPTED_LOBBY.text(connection.lobby().description());
  }
}

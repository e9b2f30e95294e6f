package org.urbi.kernel;

import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.HoldWatch;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;

/** What somebody may ask while the kernel is held, so that its own thread cannot answer. */
final class Operator {
  /** Who has held the kernel for less, in nanoseconds, is only having a turn. */
  private static final long SHORTEST_HOLD = 100_000_000;

  /** How much of a stack is told. */
  private static final int MOST_CALLS = 40;

  private final Scheduler scheduler;
  private final Map<String, KernelConnection> connections = new ConcurrentSkipListMap<>();
  private final Growth growth;
  private @Nullable TimeShares shares;
  private @Nullable KernelConnection evicted;
  private volatile @Nullable HoldWatch watch;

  Operator(Scheduler scheduler) {
    this.scheduler = scheduler;
    this.growth = new Growth(scheduler.meter(), connections.values());
  }

  void setWatch(@Nullable HoldWatch who) {
    watch = who;
  }

  void add(KernelConnection connection) {
    connections.put(connection.lobby().name(), connection);
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
    HoldWatch who = watch;
    return who == null ? 0 : who.heldFor();
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

  /** Memory is scarce, or is not; to be told several times a second. */
  void memoryScarce(boolean scarce) {
    if (scarce) {
      growth.look();
    } else {
      growth.forget();
    }
  }

  /**
   * Ends what the lobby does that has grown most, which is told so; if that was not enough, lets
   * its client go, and with it what the lobby knows; then the same for the next one.
   *
   * @return what was done, for people; empty when nobody is left
   */
  String relieve() throws InterruptedException {
    KernelConnection before = evicted;
    if (before != null && connections.containsValue(before) && !before.stays()) {
      evicted = null;
      before.close();
      return "letting " + HoldLimit.described(before.lobby()) + " go";
    }
    evicted = growth.next();
    if (evicted == null) {
      return "";
    }
    evicted.evict(Problem.MEMORY_EXHAUSTED.text());
    return "ending what is done for " + HoldLimit.described(evicted.lobby());
  }

  /** A lobby may take a part of the kernel's time alone. */
  void watchTime() {
    if (shares == null) {
      shares = new TimeShares(scheduler.meter(), connections.values());
      shares.start();
    }
  }

  /** The kernel has ended. */
  void end() {
    if (shares != null) {
      shares.stop();
    }
  }

  private String interruptHolder() {
    HoldWatch who = watch;
    Job job = scheduler.running();
    long held = who == null ? 0 : who.heldFor();
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
              .map(each -> HoldLimit.described(each.lobby()))
              .collect(Collectors.joining(", ")));
    }
    connection.interrupt();
    return Problem.INTERRUPTED_LOBBY.text(HoldLimit.described(connection.lobby()));
  }
}

package org.urbi.kernel;

import java.util.Collections;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.stream.Collectors;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.HoldWatch;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;

/** What somebody may ask while the kernel is held, so that its own thread cannot answer. */
final class Operator {
  /** Who has held the kernel for less, in nanoseconds, is only having a turn. */
  private static final long SHORTEST_HOLD = 100_000_000;

  /** How much of a stack is told. */
  private static final int MOST_CALLS = 40;

  /** For how long it is looked who runs, each millisecond, in nanoseconds. */
  private static final long SAMPLING = 50_000_000;

  private final Clock clock = new SystemClock();

  private final Scheduler scheduler;
  private final Map<String, KernelConnection> connections = new ConcurrentSkipListMap<>();
  private volatile HoldWatch watch;

  Operator(Scheduler scheduler) {
    this.scheduler = scheduler;
  }

  void setWatch(HoldWatch who) {
    watch = who;
  }

  void add(KernelConnection connection) {
    connections.put(connection.lobby().name(), connection);
  }

  void remove(KernelConnection connection) {
    if (connection.lobby() != null) {
      connections.remove(connection.lobby().name());
    }
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

  /** Ends what the lobby does that is using the kernel most, which is told so. */
  String relieve() throws InterruptedException {
    Map<KernelConnection, Integer> seen = new HashMap<>();
    // With memory short a collection may come between any two.
    long end = clock.now() + SAMPLING;
    while (clock.now() < end) {
      Job job = scheduler.running();
      for (KernelConnection each : connections.values()) {
        if (job != null && job.lobby() == each.lobby()) {
          seen.merge(each, 1, Integer::sum);
        }
      }
      Thread.sleep(1);
    }
    if (seen.isEmpty()) {
      return "no lobby";
    }
    KernelConnection most = Collections.max(seen.entrySet(), Map.Entry.comparingByValue()).getKey();
    most.evict(Problem.MEMORY_EXHAUSTED.text());
    return HoldLimit.described(most.lobby());
  }

  private String interruptHolder() {
    HoldWatch who = watch;
    Job job = scheduler.running();
    long held = who == null ? 0 : who.heldFor();
    if (held < SHORTEST_HOLD || job == null) {
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

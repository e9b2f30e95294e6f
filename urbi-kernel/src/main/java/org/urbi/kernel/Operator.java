package org.urbi.kernel;

import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.stream.Collectors;
import org.urbi.kernel.job.HoldWatch;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;

/** What somebody may ask while the kernel is held, so that its own thread cannot answer. */
final class Operator {
  /** Who has held the kernel for less, in nanoseconds, is only having a turn. */
  private static final long SHORTEST_HOLD = 100_000_000;

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

  private String interruptHolder() {
    HoldWatch who = watch;
    Job job = scheduler.running();
    long held = who == null ? 0 : who.heldFor();
    if (held < SHORTEST_HOLD || job == null) {
      return "nobody holds the kernel";
    }
    String told =
        "interrupted: "
            + HoldLimit.described(job, job.component())
            + " held the kernel for "
            + held / 100_000_000 / 10.0
            + " s";
    who.interrupt();
    return told;
  }

  private String interruptLobby(String lobby) {
    KernelConnection connection = connections.get(lobby);
    if (connection == null) {
      return "no such lobby: "
          + lobby
          + "; there are "
          + connections.values().stream()
              .map(each -> HoldLimit.described(each.lobby()))
              .collect(Collectors.joining(", "));
    }
    connection.interrupt();
    return "interrupted: " + HoldLimit.described(connection.lobby());
  }
}

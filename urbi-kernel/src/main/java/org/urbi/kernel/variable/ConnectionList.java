package org.urbi.kernel.variable;

import java.util.List;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.journal.LooseObjects;

/** All connections between variables of a kernel; it keeps none of them alive. */
public final class ConnectionList {
  private final LooseObjects<UrbiConnection> connections;
  private final boolean simulated;

  public ConnectionList(Scheduler scheduler) {
    connections = new LooseObjects<>(scheduler.journal());
    simulated = !scheduler.clock().isReal();
  }

  public void add(UrbiConnection connection) {
    remove(connection);
    connections.add(connection);
  }

  public void remove(UrbiConnection connection) {
    connections.remove(connection);
  }

  /**
   * The links between variables, the oldest first. In simulated time links whose variables nobody
   * refers to are found and left out, so that runs can be repeated; otherwise they may be listed
   * for a while.
   */
  public List<UrbiConnection> all() {
    if (simulated && !connections.isEmpty()) {
      System.gc();
    }
    return connections.all();
  }
}

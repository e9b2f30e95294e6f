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
   * Those there are, the oldest first. In simulated time those whose variables nobody refers to are
   * looked for first, so that runs can be repeated; otherwise they may be among them for a while.
   */
  public List<UrbiConnection> all() {
    if (simulated && !connections.isEmpty()) {
      System.gc();
    }
    return connections.all();
  }
}

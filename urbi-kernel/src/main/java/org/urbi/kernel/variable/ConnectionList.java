package org.urbi.kernel.variable;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;

/** All connections between variables of a kernel, as weak references. */
public final class ConnectionList {
  private final List<WeakReference<UrbiConnection>> connections = new ArrayList<>();

  public void add(UrbiConnection connection) {
    remove(connection);
    connections.add(new WeakReference<>(connection));
  }

  public void remove(UrbiConnection connection) {
    connections.removeIf(known -> known.refersTo(connection) || known.refersTo(null));
  }

  /** Those there are, the oldest first. */
  public List<UrbiConnection> all() {
    List<UrbiConnection> all = new ArrayList<>();
    for (WeakReference<UrbiConnection> each : connections) {
      UrbiConnection connection = each.get();
      if (connection != null) {
        all.add(connection);
      }
    }
    return all;
  }
}

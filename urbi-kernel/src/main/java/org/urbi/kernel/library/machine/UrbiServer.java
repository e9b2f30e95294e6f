package org.urbi.kernel.library.machine;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/** A place where connections come in (manual, "Server"). */
final class UrbiServer extends UrbiObject {
  private final List<UrbiObject> sockets = new ArrayList<>();
  private @Nullable UrbiIoService service;
  private @Nullable InetSocketAddress address;

  UrbiServer(Shape shape) {
    super(shape);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiServer(cloneShape());
  }

  @Nullable UrbiIoService service() {
    return service;
  }

  /** Makes it a server of that service, with an event of its own. */
  void setUp(Frame frame, UrbiIoService own) {
    service = own;
    Symbol name = world().symbol("connection");
    removeSlot(name);
    addSlot(name, frame.interpreter().prototypes().event.cloned());
  }

  /** The event that tells of connections, or null when a program has replaced it. */
  @Nullable UrbiEvent connection() {
    UrbiObject value = lookup(world().symbol("connection"));
    return value instanceof UrbiEvent event ? event : null;
  }

  /** Where it listens; null when it does not. */
  @Nullable InetSocketAddress address() {
    return address;
  }

  void setAddress(InetSocketAddress place) {
    address = place;
  }

  /** The sockets of the connections that have come in, oldest first. */
  List<UrbiObject> sockets() {
    return sockets;
  }
}

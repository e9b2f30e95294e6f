package org.urbi.kernel.library.machine;

import static java.util.Objects.requireNonNull;

import java.net.InetSocketAddress;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.World;
import org.urbi.kernel.outside.SocketConnection;

/** One end of a connection (manual, "Socket"). */
final class UrbiSocket extends UrbiObject {
  private @Nullable UrbiIoService service;
  private @Nullable SocketConnection link;
  private @Nullable InetSocketAddress local;
  private @Nullable InetSocketAddress remote;

  UrbiSocket(Shape shape) {
    super(shape);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiSocket(cloneShape());
  }

  @Nullable UrbiIoService service() {
    return service;
  }

  /** Makes it a socket of that service, with events of its own. */
  void setUp(Frame frame, UrbiIoService own) {
    service = own;
    for (String event : new String[] {"connected", "disconnected", "error", "received"}) {
      Symbol name = world().symbol(event);
      removeSlot(name);
      addSlot(name, frame.interpreter().prototypes().event.cloned());
    }
  }

  /** The event of that name, or null when a program has put something else in its slot. */
  @Nullable UrbiEvent event(String name) {
    UrbiObject value = lookup(world().symbol(name));
    return value instanceof UrbiEvent event ? event : null;
  }

  /** Emits one of its events. */
  void emit(Frame frame, String name, UrbiObject... payload) {
    UrbiEvent event = event(name);
    if (event != null) {
      event.emit(frame, payload);
    }
  }

  /** The connection, or null. */
  @Nullable SocketConnection link() {
    return link;
  }

  @Nullable InetSocketAddress local() {
    return local;
  }

  @Nullable InetSocketAddress remote() {
    return remote;
  }

  /**
   * Has it speak over a connection, and listen.
   *
   * @param here its address, or null
   * @param there that of the other end, or null
   */
  SocketEvents connect(
      Frame frame,
      SocketConnection over,
      @Nullable InetSocketAddress here,
      @Nullable InetSocketAddress there) {
    link = over;
    local = here;
    remote = there;
    SocketEvents own =
        new SocketEvents(frame, requireNonNull(service, "it is no prototype"), this::isWanted);
    over.open(
        new SocketConnection.Listener() {
          @Override
          public void received(byte[] bytes) {
            UrbiObject data = world().values().string(Utf8Text.text(bytes));
            own.add(told -> {
              over.consumed(bytes.length);
              if (link == over) {
                told.interpreter().send(told, UrbiSocket.this, "receive", data);
              }
            });
          }

          @Override
          public void ended(@Nullable String error) {
            own.add(told -> {
              if (link == over) {
                if (error != null) {
                  emit(told, "error", world().values().string(Utf8Text.toUrbi(error)));
                }
                disconnected(told);
              }
            });
          }
        });
    return own;
  }

  private boolean isWanted() {
    UrbiEvent received = event("received");
    World world = world();
    return received == null
        || received.hasSubscribers()
        || locate(world.symbol("receive")) != world.prototype("Socket");
  }

  /** The connection of the socket has ended. */
  void disconnected(Frame frame) {
    SocketConnection was = link;
    link = null;
    if (was != null) {
      was.close();
    }
    emit(frame, "disconnected");
  }
}

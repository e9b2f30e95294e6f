package org.urbi.kernel.library.machine;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.World;
import org.urbi.kernel.outside.Network;
import org.urbi.kernel.outside.Outside;

/** Places where connections come in (manual, "Server"). */
@UrbiType(
    value = "Server",
    doc = "A place where connections over the network come in.",
    needs = Permission.OWNER)
final class ServerType {
  private final Outside outside;

  ServerType(Outside outside) {
    this.outside = outside;
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiServer(world.values().object.cloneShape());
  }

  /** A server of a service, not listening. */
  static UrbiServer server(Frame frame, UrbiIoService service) {
    UrbiObject prototype = frame.interpreter().world().prototype("Server");
    UrbiServer server = new UrbiServer(prototype.cloneShape());
    server.setUp(frame, service);
    return server;
  }

  @Builtin(doc = "Gives it its event; it does not listen.")
  static UrbiObject init(Frame frame, UrbiServer self) {
    self.setUp(frame, IoServiceType.standard(frame));
    return self;
  }

  @Builtin(doc = "Listens on a port of a host of this machine; 0 is any port that is free.")
  void listen(Frame frame, CallSite site, UrbiServer self, String host, UrbiObject port) {
    UrbiIoService service = self.service();
    if (service == null) {
      throw frame.error(site, Problem.NOT_A_SERVER);
    }
    if (self.address() != null) {
      throw frame.error(site, Problem.SERVER_LISTENING);
    }
    // Connections may come from now on, until the kernel ends.
    SocketEvents socketEvents =
        new SocketEvents(
            frame,
            service,
            () -> {
              UrbiEvent event = self.connection();
              return event == null || event.hasSubscribers();
            });
    try {
      Network.ListeningSocket place =
          Network.listen(
              outside,
              frame.job(),
              Utf8Text.toJava(host),
              SocketType.port(frame, site, port),
              made -> accept(frame, self, service, socketEvents, made));
      self.setAddress(place.local());
      socketEvents.open();
    } catch (IOException e) {
      throw frame.error(
          site, Problem.REASON, FileAccess.lowered(Utf8Text.toUrbi(FileAccess.reason(e))));
    }
  }

  private static void accept(
      Frame frame,
      UrbiServer self,
      UrbiIoService service,
      SocketEvents socketEvents,
      Network.OpenConnection made) {
    UrbiSocket socket = SocketType.socket(frame, service);
    SocketEvents own = socket.connect(frame, made.link(), made.local(), made.remote());
    socketEvents.add(told -> {
      self.sockets().add(socket);
      UrbiEvent event = self.connection();
      if (event != null) {
        event.emit(told, socket);
      }
      own.open();
    });
  }

  @Builtin(doc = "The service that looks after it.")
  static UrbiObject getIoService(Frame frame, UrbiServer self) {
    return self.service() == null ? IoServiceType.standard(frame) : self.service();
  }

  private static InetSocketAddress listening(Frame frame, CallSite site, UrbiServer self) {
    if (self.address() == null) {
      throw frame.error(site, Problem.SERVER_NOT_LISTENING);
    }
    return self.address();
  }

  @Builtin(doc = "The host on which it listens.")
  static String host(Frame frame, CallSite site, UrbiServer self) {
    return listening(frame, site, self).getAddress().getHostAddress();
  }

  @Builtin(doc = "The port on which it listens.")
  static double port(Frame frame, CallSite site, UrbiServer self) {
    return listening(frame, site, self).getPort();
  }

  @Builtin(doc = "The sockets of the connections that have come in.")
  static List<UrbiObject> sockets(UrbiServer self) {
    return self.sockets();
  }
}

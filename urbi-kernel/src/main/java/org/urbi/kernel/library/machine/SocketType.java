package org.urbi.kernel.library.machine;

import java.io.IOException;
import java.net.InetSocketAddress;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.kernel.library.file.UrbiPath;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiBinary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.World;
import org.urbi.kernel.outside.Network;
import org.urbi.kernel.outside.Outside;
import org.urbi.kernel.outside.SocketConnection;

/** Connections over the network (manual, "Socket"). */
@UrbiType(
    value = "Socket",
    doc = "One end of a connection, over the network or a serial line.",
    needs = Permission.OWNER)
final class SocketType {
  private static final double DEFAULT_INTERVAL = 0.01;

  private final Outside outside;

  SocketType(Outside outside) {
    this.outside = outside;
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiSocket(world.values().object.cloneShape());
  }

  /** A socket of a service, not connected. */
  static UrbiSocket socket(Frame frame, UrbiIoService service) {
    UrbiObject prototype = frame.interpreter().world().prototype("Socket");
    UrbiSocket socket = new UrbiSocket(prototype.cloneShape());
    socket.setUp(frame, service);
    return socket;
  }

  /** A port as a string: the number, or the name of a service. */
  static String port(Frame frame, CallSite site, UrbiObject port) {
    return port instanceof UrbiFloat
        ? Integer.toString(Arguments.integer(frame, site, 2, port))
        : Utf8Text.toJava(Arguments.text(frame, site, 2, port));
  }

  @Builtin(doc = "Gives it its events; it is not connected.")
  static UrbiObject init(Frame frame, UrbiSocket self) {
    self.setUp(frame, IoServiceType.standard(frame));
    return self;
  }

  // ------------------------------------------------------------------ connecting

  /** Refuses a socket that is no socket, or connected already. */
  private static void checkUnconnected(Frame frame, CallSite site, UrbiSocket self) {
    if (self.service() == null) {
      throw frame.error(site, Problem.NOT_A_SOCKET);
    }
    if (self.link() != null) {
      throw frame.error(site, Problem.SOCKET_CONNECTED);
    }
  }

  @Builtin(doc = "Connects to a port of a host; the port is a number or the name of a service.")
  void connect(Frame frame, CallSite site, UrbiSocket self, String host, UrbiObject port) {
    checkUnconnected(frame, site, self);
    try {
      Network.OpenConnection made =
          Network.connect(outside, frame.job(), Utf8Text.toJava(host), port(frame, site, port));
      connected(frame, self, made.link(), made.local(), made.remote());
    } catch (IOException e) {
      throw frame.error(
          site, Problem.REASON, FileAccess.lowered(Utf8Text.toUrbi(FileAccess.reason(e))));
    }
  }

  @Builtin(doc = "Connects to a serial line, with that speed.")
  void connectSerial(Frame frame, CallSite site, UrbiSocket self, UrbiObject device, int baudRate) {
    checkUnconnected(frame, site, self);
    UrbiPath path = FileAccess.path(frame, site, 1, device);
    try {
      SocketConnection link = Network.serial(outside, frame.job(), path.file(), baudRate);
      connected(frame, self, link, null, null);
    } catch (IOException e) {
      throw frame.error(site, Problem.REASON, Utf8Text.toUrbi(FileAccess.reason(e)));
    }
  }

  private static void connected(
      Frame frame,
      UrbiSocket self,
      SocketConnection link,
      @Nullable InetSocketAddress local,
      @Nullable InetSocketAddress remote) {
    SocketEvents socketEvents = self.connect(frame, link, local, remote);
    self.emit(frame, "connected");
    socketEvents.open();
  }

  @Builtin(doc = "Closes the connection, as soon as all that was written is sent.")
  static void disconnect(Frame frame, UrbiSocket self) {
    if (self.link() != null) {
      self.disconnected(frame);
    }
  }

  @Builtin(doc = "Whether it is connected.")
  static boolean isConnected(UrbiSocket self) {
    return self.link() != null;
  }

  // ------------------------------------------------------------------ where it is

  private static InetSocketAddress known(
      Frame frame, CallSite site, UrbiSocket self, @Nullable InetSocketAddress address) {
    if (self.link() == null || address == null) {
      throw frame.error(site, Problem.SOCKET_NOT_CONNECTED);
    }
    return address;
  }

  @Builtin(doc = "The host at the other end.")
  static String host(Frame frame, CallSite site, UrbiSocket self) {
    return known(frame, site, self, self.remote()).getAddress().getHostAddress();
  }

  @Builtin(doc = "The port at the other end.")
  static double port(Frame frame, CallSite site, UrbiSocket self) {
    return known(frame, site, self, self.remote()).getPort();
  }

  @Builtin(doc = "The host at this end.")
  static String localHost(Frame frame, CallSite site, UrbiSocket self) {
    return known(frame, site, self, self.local()).getAddress().getHostAddress();
  }

  @Builtin(doc = "The port at this end.")
  static double localPort(Frame frame, CallSite site, UrbiSocket self) {
    return known(frame, site, self, self.local()).getPort();
  }

  // ------------------------------------------------------------------ speaking

  @Builtin(doc = "Sends data, a String or a Binary, soon.")
  static void write(Frame frame, CallSite site, UrbiSocket self, UrbiObject data) {
    send(frame, site, self, data, false);
  }

  @Builtin(doc = "Sends data, a String or a Binary, and waits until they are sent.")
  static void syncWrite(Frame frame, CallSite site, UrbiSocket self, UrbiObject data) {
    send(frame, site, self, data, true);
  }

  private static void send(
      Frame frame, CallSite site, UrbiSocket self, UrbiObject data, boolean wait) {
    String bytes =
        data instanceof UrbiBinary binary ? binary.data() : Arguments.text(frame, site, 1, data);
    SocketConnection link = self.link();
    if (link == null) {
      throw frame.error(site, Problem.SOCKET_NOT_CONNECTED);
    }
    try {
      link.write(frame.job(), Utf8Text.bytes(bytes));
      if (wait) {
        link.flush(frame.job());
      }
    } catch (IOException e) {
      throw frame.error(site, Problem.REASON, FileAccess.lowered(FileAccess.reason(e)));
    }
  }

  @Builtin(doc = "Called with the data that have come: emits received.")
  static void receive(Frame frame, UrbiSocket self, UrbiObject data) {
    self.emit(frame, "received", data);
  }

  // ------------------------------------------------------------------ polling

  /** The service of a socket; the default one for the prototype. */
  private static UrbiIoService service(Frame frame, UrbiSocket self) {
    return self.service() == null ? IoServiceType.standard(frame) : self.service();
  }

  @Builtin(doc = "The service that looks after it.")
  static UrbiObject getIoService(Frame frame, UrbiSocket self) {
    return service(frame, self);
  }

  @Builtin(doc = "Has its service tell what has happened.")
  static void poll(Frame frame, UrbiSocket self) {
    service(frame, self).poll(frame.job());
  }

  @Builtin(doc = "How often the default service is polled, in seconds; 0: not by itself.")
  static double pollInterval(Frame frame, UrbiSocket self) {
    return IoServiceType.standard(frame).isAutomatic() ? DEFAULT_INTERVAL : 0;
  }

  @Builtin(value = "pollInterval", setter = true, doc = "Sets how often; 0: not by itself.")
  static void setPollInterval(Frame frame, UrbiSocket self, double seconds) {
    // More often than at once it cannot be.
    IoServiceType.standard(frame).setPaused(seconds <= 0);
  }
}

package org.urbi.kernel.library.machine;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Looks after sockets (manual, "IoService"). */
@UrbiType(
    value = "IoService",
    doc = "Looks after sockets and servers, and tells what happens.",
    needs = Permission.OWNER)
final class IoServiceType {
  private IoServiceType() {}

  /** The prototype is the default service. */
  static UrbiObject newPrototype(World world) {
    return new UrbiIoService(world.values().object.cloneShape(), true);
  }

  /** The default service. */
  static UrbiIoService standard(Frame frame) {
    return (UrbiIoService) frame.interpreter().world().prototype("IoService");
  }

  @Builtin(doc = "A Server that this service looks after.")
  static UrbiObject makeServer(Frame frame, UrbiIoService self) {
    return ServerType.server(frame, self);
  }

  @Builtin(doc = "A Socket that this service looks after.")
  static UrbiObject makeSocket(Frame frame, UrbiIoService self) {
    return SocketType.socket(frame, self);
  }

  @Builtin(doc = "Tells what has happened so far, and does not wait.")
  static void poll(Frame frame, UrbiIoService self) {
    self.poll(frame.job());
  }

  @Builtin(doc = "Tells what happens during so many seconds.")
  static void pollFor(Frame frame, UrbiIoService self, double duration) {
    self.pollUntil(frame.job(), deadline(frame, duration), false);
  }

  @Builtin(doc = "Waits at most so many seconds for something to happen, and tells of that.")
  static void pollOneFor(Frame frame, UrbiIoService self, double duration) {
    self.pollUntil(frame.job(), deadline(frame, duration), true);
  }

  private static long deadline(Frame frame, double duration) {
    return frame.job().scheduler().now() + Durations.nanoseconds(duration);
  }
}

package org.urbi.kernel.library.system;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.library.lobby.LobbyType;
import org.urbi.kernel.library.lobby.Warnings;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** Functions of urbiscript 1 (manual, "Kernel1"). */
@UrbiType(
    value = "Kernel1",
    protos = {"Singleton"},
    doc = "Functions that are there for old programs only.",
    needs = Permission.NOTHING)
final class Kernel1Type {
  private Kernel1Type() {}

  @Builtin(
      value = {
        "commands",
        "connections",
        "devices",
        "events",
        "functions",
        "noop",
        "reset",
        "runningcommands",
        "strict",
        "taglist",
        "undefall",
        "unstrict",
        "uservars",
        "vars"
      },
      doc = "Does nothing.")
  static void nothing(UrbiObject self) {}

  @Builtin(doc = "Warns that something is deprecated, and names what to use instead.")
  static void deprecated(Frame frame, UrbiObject self, String old, String other) {
    Warnings.deprecated(frame, old, other);
  }

  private static UrbiObject bounce(
      Frame frame, CallSite site, String argument, UrbiObject value, String method) {
    Warnings.deprecated(
        frame, site, site.calledName() + "(" + argument + ")", argument + "." + method);
    return frame.interpreter().send(frame, value, method);
  }

  @Builtin(doc = "Deprecated: use binary.copy.")
  static UrbiObject copy(Frame frame, CallSite site, UrbiObject self, UrbiObject binary) {
    return bounce(frame, site, "binary", binary, "copy");
  }

  @Builtin(lazy = true, min = 1, max = 1, doc = "Deprecated: use obj.isVoid.")
  static UrbiObject isvoid(Frame frame, CallSite site, UrbiObject self) {
    return bounce(frame, site, "obj", site.argumentNodes()[0].execute(frame), "isVoid");
  }

  @Builtin(doc = "Deprecated: use number.seq.")
  static UrbiObject seq(Frame frame, CallSite site, UrbiObject self, UrbiObject number) {
    return bounce(frame, site, "number", number, "seq");
  }

  @Builtin(doc = "Deprecated: use list.size.")
  static UrbiObject size(Frame frame, CallSite site, UrbiObject self, UrbiObject list) {
    return bounce(frame, site, "list", list, "size");
  }

  @Builtin(doc = "Deprecated: use string.length.")
  static UrbiObject strlen(Frame frame, CallSite site, UrbiObject self, UrbiObject string) {
    return bounce(frame, site, "string", string, "length");
  }

  @Builtin(doc = "Tells the time.")
  static void ping(Frame frame, UrbiObject self) {
    UrbiObject time =
        self.world().values().number(Durations.seconds(frame.job().scheduler().measure()));
    LobbyType.output(frame)
        .send("", "*** pong time=" + frame.interpreter().asString(frame, time) + "s");
  }
}

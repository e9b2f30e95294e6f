package org.urbi.kernel.library.lobby;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** Labelled output (manual, "Channel"). */
@UrbiType(
    value = "Channel",
    doc = "A label under which values are sent to the client.",
    needs = Permission.NOTHING)
final class ChannelType {
  private ChannelType() {}

  @Builtin(doc = "Labels the output with that name.", needs = Permission.CHANGE)
  static void init(Frame frame, UrbiObject self, String name) {
    self.addSlot(self.world().symbol("name"), frame.interpreter().values().string(name));
  }

  @Builtin(
      value = {"<<"},
      doc = "Sends a value to the client.")
  static void send(Frame frame, UrbiObject self, UrbiObject value) {
    if (value != frame.interpreter().values().nil && isOn(frame, self, "enabled")) {
      String text =
          value instanceof UrbiString string && !isOn(frame, self, "quote")
              ? string.value()
              : frame
                  .interpreter()
                  .asString(frame, frame.interpreter().send(frame, value, "asToplevelPrintable"));
      LobbyType.output(frame, "<<", self).send(name(frame, self), text);
    }
  }

  @Builtin(doc = "Sends a value as a message.")
  static void echo(Frame frame, UrbiObject self, UrbiObject value) {
    if (isOn(frame, self, "enabled")) {
      LobbyType.output(frame, "echo", self)
          .send(name(frame, self), "*** " + frame.interpreter().asString(frame, value));
    }
  }

  private static String name(Frame frame, UrbiObject self) {
    return frame.interpreter().asString(frame, frame.interpreter().send(frame, self, "name"));
  }

  private static boolean isOn(Frame frame, UrbiObject self, String slot) {
    return Truth.of(frame, frame.interpreter().send(frame, self, slot));
  }
}

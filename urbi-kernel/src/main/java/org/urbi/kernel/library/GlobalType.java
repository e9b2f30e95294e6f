package org.urbi.kernel.library;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** What can be named from everywhere (manual, "Global"). */
@UrbiType(
    value = "Global",
    protos = {"Tag.tags", "Control", "Math", "System"},
    doc = "The namespace of all objects.")
final class GlobalType {
  private GlobalType() {}

  @Builtin(doc = "Sends a value as text to the lobby, on a channel if one is given.")
  static void echo(Frame frame, UrbiObject self, UrbiObject value, @Optional String channel) {
    LobbyType.echo(frame, LobbyType.of(frame), value, channel);
  }
}

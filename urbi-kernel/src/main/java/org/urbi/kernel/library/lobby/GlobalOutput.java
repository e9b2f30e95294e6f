package org.urbi.kernel.library.lobby;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.kernel.lobby.Lobbies;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** Output of code that names no lobby (manual, "Global": echo, wall, warn). */
@UrbiTypePart(value = "Global", needs = Permission.NOTHING)
final class GlobalOutput {
  /** What users send to all is not to be taken for something else: each line is marked. */
  private static final String BREAK = "[\\r\\n]";

  private final Lobbies lobbies;

  GlobalOutput(Lobbies lobbies) {
    this.lobbies = lobbies;
  }

  @Builtin(doc = "Sends a value as text to the lobby, as the echo of that does.")
  static void echo(
      Frame frame,
      UrbiObject self,
      UrbiObject value,
      @Optional @Nullable String channel,
      @Optional @Nullable String prefix) {
    LobbyType.echo(frame, LobbyType.of(frame), value, channel, prefix);
  }

  @Builtin(
      doc = "Sends a value as text to all lobbies, on a channel if one is given.",
      needs = Permission.USER)
  void wall(Frame frame, UrbiObject self, UrbiObject value, @Optional @Nullable String channel) {
    String text = frame.interpreter().asString(frame, value);
    String on = channel == null ? "" : channel;
    UrbiLobby sender = LobbyType.of(frame);
    boolean trusted = frame.job().isOwner();
    String[] lines = trusted ? new String[] {text} : text.split(BREAK, -1);
    // The sender gets it as the others do, and needs room for it.
    LobbyType.output(frame, sender);
    for (UrbiLobby lobby : lobbies.all()) {
      Output to = lobby.output();
      // A lobby created by a program sends its output to its creator, which gets the text anyway.
      boolean passedOver = to.isBranch() || !trusted && lobby != sender && to.isBehind();
      for (int i = 0; i < lines.length && !passedOver; i++) {
        to.send(trusted ? on : on.replaceAll(BREAK, " "), "*** " + lines[i]);
      }
    }
  }

  @Builtin(doc = "Sends a message to the channel warning.")
  static void warn(Frame frame, UrbiObject self, UrbiObject message) {
    Diagnostics.warning(LobbyType.output(frame), frame.interpreter().asString(frame, message));
  }
}

package org.urbi.kernel.library.reference;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.library.lobby.LobbyType;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** {@code help}, for people who want to know. */
@UrbiTypePart(value = "Object", needs = Permission.NOTHING)
final class HelpFunction {
  private final Topics topics;

  HelpFunction(Topics topics) {
    this.topics = topics;
  }

  @Builtin(
      doc =
          "Shows what the reference says of the target, or of what is given: an object, the name of"
              + " one of its slots, or a topic.")
  void help(Frame frame, UrbiObject self, @Optional @Nullable UrbiObject subject) {
    UrbiLobby lobby = LobbyType.of(frame);
    Help help = new Help(lobby, topics);
    boolean general = self instanceof UrbiLobby;
    List<String> lines;
    if (subject instanceof UrbiString topic) {
      lines = general ? help.about(topic.value()) : help.about(self, topic.value());
    } else if (subject != null) {
      lines = help.about(subject);
    } else {
      lines = general ? help.overview() : help.about(self);
    }
    Output output = LobbyType.output(frame, lobby);
    for (String line : lines) {
      output.send("", ("*** " + line).stripTrailing());
    }
  }
}

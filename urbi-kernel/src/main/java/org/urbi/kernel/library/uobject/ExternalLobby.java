package org.urbi.kernel.library.uobject;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.external.ExternalProcess;
import org.urbi.kernel.library.lobby.LobbyType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.uobject.PluggedContext;

/** Functions of the lobby for processes that are linked with the SDK of Urbi 2.7. */
@UrbiTypePart(value = "Lobby", needs = Permission.OWNER)
final class ExternalLobby {
  /** More arguments no function can have. */
  private static final int MOST_ARGUMENTS = 100;

  private final PluggedContext uobjects;

  ExternalLobby(PluggedContext uobjects) {
    this.uobjects = uobjects;
  }

  @Builtin(
      doc =
          "What \"external object\", \"external var\", and so on, call: the process at the other"
              + " end has an object, a function, uses a variable, listens to an event.")
  void external(
      Frame frame,
      UrbiObject self,
      String kind,
      String first,
      @Nullable @Optional String second,
      @Nullable @Optional String third) {
    ExternalProcess process = ExternalProcess.of(frame, uobjects);
    ExternalProcess.attempt(
        frame,
        "external " + kind,
        () -> {
          switch (kind) {
            case "object" -> process.declareObject(Utf8Text.toJava(first));
            case "var" -> process.variables().use(Utf8Text.toJava(first));
            case "function" -> process.declareFunction(arity(first), name(second));
            case "event" -> process.events().listen(frame, arity(first), name(second));
            default -> throw new IllegalArgumentException(Problem.NOTHING_EXTERNAL.text(kind));
          }
        });
  }

  private static int arity(String text) {
    if (!text.matches("[0-9]{1,3}") || Integer.parseInt(text) > MOST_ARGUMENTS) {
      throw new IllegalArgumentException(Problem.NO_NUMBER_OF_ARGUMENTS.text(text));
    }
    return Integer.parseInt(text);
  }

  private static String name(@Nullable String text) {
    if (text == null) {
      throw new IllegalArgumentException(Problem.NAME_MISSING.text());
    }
    return Utf8Text.toJava(text);
  }

  @Builtin(
      doc = "Has the process at the other end go on in messages; true is sent on that channel.")
  void binaryMode(Frame frame, UrbiObject self, double mode, String channel) {
    if (mode != 0 && LobbyType.of(frame).shell() != null) {
      ExternalProcess.of(frame, uobjects).beginBinaryMode();
    }
    LobbyType.of(frame).output().send(channel, "true");
  }
}

package org.urbi.kernel.library.machine;

import java.io.IOException;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.file.FileAccess;
import org.urbi.kernel.library.lobby.LobbyType;
import org.urbi.kernel.lobby.Lobbies;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.outside.Network;
import org.urbi.kernel.outside.Outside;

/** Lobbies of clients that wait to be called, as {@code urbi-launch --server} of Urbi 2.7 does. */
@UrbiTypePart(value = "Lobby", needs = Permission.OWNER)
final class ReverseConnection {
  private final Lobbies lobbies;
  private final Outside outside;

  ReverseConnection(Lobbies lobbies, Outside outside) {
    this.lobbies = lobbies;
    this.outside = outside;
  }

  @Builtin(
      doc =
          "Connects to a client that listens on a port of a host, and executes what it sends, with"
              + " the role of the caller: its lobby.")
  UrbiObject reverseConnect(
      Frame frame, CallSite site, UrbiObject self, String host, UrbiObject port) {
    try {
      Network.OpenConnection made =
          Network.connect(
              outside, frame.job(), Utf8Text.toJava(host), SocketType.port(frame, site, port));
      String address = made.remote().getAddress().getHostAddress();
      return lobbies.call(LobbyType.of(frame), made.link(), address);
    } catch (IOException e) {
      throw frame.error(
          site, Problem.REASON, FileAccess.lowered(Utf8Text.toUrbi(FileAccess.reason(e))));
    }
  }
}

package org.urbi.kernel.lobby;

import java.util.List;
import org.urbi.kernel.outside.SocketConnection;

/** The lobbies of one kernel (manual, "Lobby"). */
public interface Lobbies {
  /** Those of all connections, and those made by programs. */
  List<UrbiLobby> all();

  /** A lobby without a connection of its own: its output goes where that of another one does. */
  UrbiLobby create(UrbiLobby creator);

  /**
   * The lobby of a client that the kernel has called.
   *
   * @param caller whose rights it has
   * @param link not open yet
   * @param address of the client
   */
  UrbiLobby call(UrbiLobby caller, SocketConnection link, String address);

  /** The lobby of code that belongs to no connection. */
  UrbiLobby system();
}

package org.urbi.kernel.lobby;

import java.util.List;
import org.urbi.kernel.outside.SocketConnection;

/** The lobbies of one kernel (manual, "Lobby"). */
public interface Lobbies {
  /** All lobbies: those of connections, and those created by programs. */
  List<UrbiLobby> all();

  /**
   * Creates a lobby without a connection of its own, whose output goes where that of its creator
   * goes.
   */
  UrbiLobby create(UrbiLobby creator);

  /**
   * The lobby of a client that the kernel has called.
   *
   * @param caller the lobby whose role and budget it gets
   * @param link not open yet
   * @param address of the client
   */
  UrbiLobby call(UrbiLobby caller, SocketConnection link, String address);

  /** The lobby of code that belongs to no connection. */
  UrbiLobby system();
}

package org.urbi.kernel.lobby;

/** The UObjects that the client of a lobby has brought by urbiscript. On the kernel thread. */
public interface RemoteObjects {
  /** A statement of the client is over. */
  void statementOver();

  /** The client has gone, and so do the objects. */
  void disconnected();
}

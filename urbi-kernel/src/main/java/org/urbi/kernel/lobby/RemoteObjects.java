package org.urbi.kernel.lobby;

/**
 * The UObjects that the client of a lobby has declared by urbiscript. Used on the kernel thread.
 */
public interface RemoteObjects {
  /** A statement of the client has ended. */
  void statementOver();

  /** The client has disconnected: ends the objects. */
  void disconnected();
}

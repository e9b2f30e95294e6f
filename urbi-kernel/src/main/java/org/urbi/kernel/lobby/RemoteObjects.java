package org.urbi.kernel.lobby;

/**
 * The UObjects that the client of a lobby has declared by urbiscript. Used on the kernel thread.
 */
public interface RemoteObjects {
  /** A statement of the client has ended. */
  void statementOver();

  /** The client has disconnected: ends the objects. */
  void disconnected();

  /**
   * The client uses a variable less.
   *
   * @param times how many of its uses end: each variable of its own that stands for it is one, and
   *     so is what is notified of its changes
   */
  void unnotify(String variable, double times);
}

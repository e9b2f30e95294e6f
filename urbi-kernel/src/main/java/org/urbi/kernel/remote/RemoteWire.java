package org.urbi.kernel.remote;

/** The way to a remote process. Its methods may be called from any thread, and never wait. */
public interface RemoteWire {
  /** Sends whole frames. */
  void send(byte[] frames);

  /** How many bytes have been sent and have not left yet. */
  long pending();

  /** Ends the connection. */
  void close(String reason);

  /** The kernel has done so much of what has come in. */
  void consumed(int bytes);
}

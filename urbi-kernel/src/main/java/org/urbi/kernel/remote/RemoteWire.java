package org.urbi.kernel.remote;

import urbi.rtp.RtpSession;
import urbi.rtp.RtpTerms;

/** The way to a remote process. Its methods may be called from any thread, and never wait. */
public interface RemoteWire {
  /** Sends whole frames. */
  void send(byte[] frames);

  /** How many bytes have been sent and have not left yet. */
  long pending();

  /** Ends the connection. */
  void close(String reason);

  /**
   * Takes up the offer of datagrams, and tells the process the terms, or that there are none.
   *
   * @param terms those of the process
   */
  void openDatagrams(RtpTerms terms);

  /** The datagrams that were agreed upon; null without. */
  RtpSession datagrams();

  /** Ends the datagrams, if there are any. */
  void closeDatagrams();

  /** The kernel has done so much of what has come in. */
  void consumed(int bytes);
}

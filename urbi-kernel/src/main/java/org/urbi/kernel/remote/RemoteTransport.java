package org.urbi.kernel.remote;

import java.nio.ByteBuffer;
import org.jspecify.annotations.Nullable;
import urbi.rtp.RtpParameters;
import urbi.rtp.RtpSession;

/** The way to a remote process. Its methods may be called from any thread, and never wait. */
public interface RemoteTransport {
  /** Sends whole frames. */
  void send(byte[] frames);

  /** Ends the connection. */
  void close(String reason);

  /**
   * Takes up the offer of datagrams, and tells the process the terms, or that there are none.
   *
   * @param terms those of the process
   */
  void openDatagrams(RtpParameters terms);

  /** The datagrams that were agreed upon; null without. */
  @Nullable RtpSession datagrams();

  /** Ends the datagrams, if there are any. */
  void closeDatagrams();

  /** The kernel has done so much of what has come in. */
  void consumed(int bytes);

  /**
   * Asks for the connection to be left to the kernel thread, which reads from it by {@link #read}
   * from when {@link RemotePeer#mayRead} is called on; if ever.
   */
  void wantToRead();

  /**
   * Reads what there is, without waiting, and gives it to the peer; on the kernel thread.
   *
   * @param space for the bytes
   * @return false if the network reads again, from now on
   */
  boolean read(ByteBuffer space);

  /** The network is to read again. */
  void stopReading();

  /** The kernel thread, to which the connection has been left, is there to read. */
  void attended();
}

package org.urbi.kernel.remote;

import java.nio.ByteBuffer;
import org.jspecify.annotations.Nullable;
import urbi.rtp.RtpParameters;
import urbi.rtp.RtpSession;

/**
 * The connection to a remote process, as the kernel uses it. Its methods may be called from any
 * thread, and never wait.
 */
public interface RemoteTransport {
  /** The number of the connection whose lobby executes what the process sends; -1 without one. */
  default int console() {
    return -1;
  }

  /** Sends whole frames. */
  void send(byte[] frames);

  /** Ends the connection. */
  void close(String reason);

  /**
   * Accepts the offer of datagrams, and sends the process the parameters, or a refusal.
   *
   * @param terms the parameters of the process
   */
  void openDatagrams(RtpParameters terms);

  /** The datagram session; null if there is none. */
  @Nullable RtpSession datagrams();

  /** Ends the datagrams, if there are any. */
  void closeDatagrams();

  /** The kernel has processed that many bytes of input. */
  void consumed(int bytes);

  /**
   * Asks to hand the connection over to the kernel thread. Once {@link RemotePeer#mayRead} is
   * called, if ever, the kernel thread reads by {@link #read}.
   */
  void wantToRead();

  /**
   * Reads what has arrived, without waiting, and passes it to the peer; on the kernel thread.
   *
   * @param space for the bytes
   * @return false if the network thread reads again from now on
   */
  boolean read(ByteBuffer space);

  /** Lets the network thread read again. */
  void stopReading();

  /** Confirms that the kernel thread, which has taken over the connection, is idle and can read. */
  void attended();
}

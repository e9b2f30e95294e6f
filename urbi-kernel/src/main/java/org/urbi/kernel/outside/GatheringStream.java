package org.urbi.kernel.outside;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;

/**
 * What comes over a socket, read together if it comes together. In Urbi 2.7, sockets were looked at
 * every 10 ms, and programs rely on being told at once of the last data of a connection and of its
 * end, though the other side closed it a moment after it had sent them.
 */
final class GatheringStream extends InputStream {
  /** How long what has been read waits for more, in milliseconds. */
  private static final int WAIT = 5;

  /** How often it does so, so that what drips in is not kept for long. */
  private static final int WAITS = 2;

  private final Socket socket;
  private final InputStream in;

  /**
   * @throws IOException if the socket is not connected
   */
  GatheringStream(Socket socket) throws IOException {
    this.socket = socket;
    in = socket.getInputStream();
  }

  @Override
  public int read() throws IOException {
    byte[] one = new byte[1];
    return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
  }

  @Override
  public int read(byte[] bytes, int from, int length) throws IOException {
    socket.setSoTimeout(0);
    int all = in.read(bytes, from, length);
    if (all > 0 && all < length) {
      try {
        socket.setSoTimeout(WAIT);
        for (int i = 0; i < WAITS && all < length; i++) {
          int more = in.read(bytes, from + all, length - all);
          if (more < 0) {
            break;
          }
          all += more;
        }
      } catch (IOException e) {
        // Nothing came in time; or the connection is broken, which the next reading tells.
        return all;
      }
    }
    return all;
  }
}

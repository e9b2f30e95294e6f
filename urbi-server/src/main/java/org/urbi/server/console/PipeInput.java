package org.urbi.server.console;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.urbi.kernel.Connection;

/** Reads a stream that is not a terminal, and passes its bytes to a lobby as they arrive. */
public final class PipeInput {
  private static final int CHUNK = 64 << 10;

  private final InputStream stream;
  private final Console console;
  private final Connection connection;
  private final boolean all;

  /**
   * @param all whether to read on however much the kernel has not taken: it may be waiting for the
   *     end of the input
   */
  public PipeInput(InputStream stream, Console console, Connection connection, boolean all) {
    this.stream = stream;
    this.console = console;
    this.connection = connection;
    this.all = all;
  }

  /** Reads until the stream or the lobby ends. */
  public void run() {
    byte[] chunk = new byte[CHUNK];
    try {
      for (int n = stream.read(chunk); n >= 0 && console.isOpen(); n = stream.read(chunk)) {
        connection.send(new String(chunk, 0, n, StandardCharsets.ISO_8859_1));
        if (!all) {
          console.awaitInputConsumed(connection);
        }
      }
    } catch (IOException e) {
      // The terminal has gone or the descriptor is closed: the input has ended.
    }
  }
}

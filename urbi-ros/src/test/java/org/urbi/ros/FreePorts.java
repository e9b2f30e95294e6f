package org.urbi.ros;

import java.io.IOException;
import java.net.BindException;
import java.net.ServerSocket;
import java.util.ArrayList;
import java.util.List;

/**
 * Ports for programs that listen later. The system gives none of these to a socket that asks for
 * any, and no two JVMs that run beside each other get the same one.
 */
public final class FreePorts {
  /** The system's own begin above, on Linux. */
  private static final int END = 32_768;

  /** Each is bound as long as this JVM lives, and reserves the port after it. */
  private static final List<ServerSocket> RESERVED = new ArrayList<>();

  private static int candidate = 20_000;

  private FreePorts() {}

  /** A port at which nobody listens; nobody else gets it as long as this JVM lives. */
  public static synchronized int next() throws IOException {
    while (candidate < END) {
      int port = candidate + 1;
      candidate += 2;
      try {
        RESERVED.add(new ServerSocket(port - 1));
        new ServerSocket(port).close();
        return port;
      } catch (BindException e) {
        // Another JVM has it, or another program.
      }
    }
    throw new IOException("no free port below " + END);
  }
}

package org.urbi.server.isolated;

import java.io.IOException;
import java.time.Duration;
import org.urbi.bridge.NativeThreads;
import urbi.UClientException;
import urbi.remote.IsolatedProgram;

/** The program in which a server runs a module; {@link IsolatedProcess} starts it. */
public final class IsolatedModule {
  private static final int FAILED = 1;

  private IsolatedModule() {}

  /**
   * @param args the port of the server, the milliseconds that code may hold up the rest, and for
   *     people the name of the module
   */
  public static void main(String[] args) {
    int port = Integer.parseInt(args[0]);
    Duration limit = Duration.ofMillis(Long.parseLong(args[1]));
    int status = 0;
    try {
      new IsolatedProgram(port, limit, System.in, () -> NativeThreads.halt(0)).run();
    } catch (IOException | UClientException e) {
      System.err.println(e.getMessage());
      status = FAILED;
    }
    NativeThreads.halt(status);
  }
}

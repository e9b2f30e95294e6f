package org.urbi.server.cli;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.urbi.server.tools.UrbiPing;
import org.urbi.server.tools.UrbiSend;

/**
 * What the build runs once to make the start-up cache: the ways in which the programs are started
 * most, one after the other in one process. The JDK keeps the classes that they load and the
 * profiles of what they execute.
 */
public final class Rehearsal {
  private final PrintStream nowhere =
      new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);

  private Rehearsal() {}

  /**
   * @param args a script to be run, which must not end the server
   */
  public static void main(String[] args) throws IOException {
    String script = args[0];
    Rehearsal rehearsal = new Rehearsal();
    rehearsal.urbi("-q", "-e", "echo(\"Hello, World!\");", "-e", "shutdown;");
    rehearsal.urbi("--quiet", "--fast", script);
    rehearsal.urbi("-i", "-f", script);
    rehearsal.network(Files.createTempDirectory("urbi").resolve("port"));
    System.exit(0);
  }

  private void urbi(String... args) {
    new UrbiCommand(nowhere, System.err).run(args);
  }

  private void network(Path portFile) throws IOException {
    Thread server = new Thread(() -> urbi("-P0", "-d", "NONE", "--port-file", portFile.toString()));
    server.start();
    while (!Files.exists(portFile)) {
      if (!server.isAlive()) {
        throw new IOException("the server did not start");
      }
      Thread.onSpinWait();
    }
    String target = "--port-file=" + portFile;
    UrbiPing.run(new String[] {target, "-c", "2", "-i", "0"}, nowhere, nowhere);
    UrbiSend.run(new String[] {target, "-e", "1;", "-Q"}, nowhere, nowhere);
    UrbiSend.run(new String[] {target, "-e", "shutdown;"}, nowhere, nowhere);
  }
}

package org.urbi.tests.process;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** The program {@code urbi} as a server on a free port. */
final class ServerProcess implements AutoCloseable {
  private static final String LISTENING = "listening on 127.0.0.1:";

  private final JavaProcess process;
  private final int port;

  /** Starts a server in a folder. */
  static ServerProcess in(Path folder, String... options) throws IOException, InterruptedException {
    return in(JavaProcess.Setting.in(folder), options);
  }

  /** Starts a server in a setting. */
  static ServerProcess in(JavaProcess.Setting setting, String... options)
      throws IOException, InterruptedException {
    List<String> arguments = new ArrayList<>(List.of("--port", "0"));
    Collections.addAll(arguments, options);
    return new ServerProcess(
        JavaProcess.start(setting, "org.urbi.server.cli.UrbiCommand", arguments));
  }

  /** Waits until it has said something on its own outputs. */
  String awaitText(String text) throws InterruptedException {
    return process.awaitText(text);
  }

  /** A server that is being started, in whatever way, and tells its port. */
  ServerProcess(JavaProcess process) throws InterruptedException {
    this.process = process;
    String line = process.awaitText(LISTENING);
    String address = line.substring(line.indexOf(LISTENING) + LISTENING.length());
    port = Integer.parseInt(address.replaceFirst(", by TLS$", ""));
  }

  long pid() {
    return process.pid();
  }

  int port() {
    return port;
  }

  /** A new client of it. */
  ConsoleClient connect() throws IOException {
    return new ConsoleClient(port);
  }

  /** What it has said on its own outputs. */
  String text() {
    return process.text();
  }

  /** Asks it to end, as the system does. */
  void terminate() {
    process.terminate();
  }

  /** Waits for its end, and returns its exit status. */
  int awaitEnd() throws InterruptedException {
    return process.awaitEnd();
  }

  /** Shuts it down and returns its exit status. */
  int shutDown() throws IOException, InterruptedException {
    try (ConsoleClient client = connect()) {
      client.send("shutdown;\n");
    }
    return process.awaitEnd();
  }

  @Override
  public void close() {
    process.close();
  }
}

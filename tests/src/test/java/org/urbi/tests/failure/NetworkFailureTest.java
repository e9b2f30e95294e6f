package org.urbi.tests.failure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.tests.TestTimeout;

/** A class that the network thread cannot load. */
class NetworkFailureTest {
  private static final byte[] INTERRUPT = {(byte) 255, (byte) 244};

  @TempDir Path folder;

  private CompletableFuture<Programs.Run> server(String missing) {
    // The server of one test stays, so it must not have a thread that all tests share.
    return CompletableFuture.supplyAsync(
        () -> {
          try {
            return Programs.run(
                Set.of(missing),
                List.of("--port", "0", "--port-file", folder.resolve("port") + ""));
          } catch (Exception e) {
            throw new IllegalStateException(e);
          }
        },
        task -> Thread.ofPlatform().daemon().start(task));
  }

  private Socket connect() throws Exception {
    Path file = folder.resolve("port");
    while (!Files.exists(file)) {
      Thread.sleep(10);
    }
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), port(file));
    socket.setSoTimeout((int) TestTimeout.LONG.toMillis());
    return socket;
  }

  private static int port(Path file) throws IOException {
    return Integer.parseInt(Files.readString(file).strip());
  }

  private static void send(Socket socket, String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  private static BufferedReader reader(Socket socket) throws IOException {
    return new BufferedReader(
        new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
  }

  private static void endsWith(BufferedReader in, String end) throws IOException {
    String line = in.readLine();
    assertTrue(line != null && line.endsWith(end), line);
  }

  @Test
  void clientGetsTheErrorAndContinues() throws Exception {
    CompletableFuture<Programs.Run> server = server("org.urbi.server.net.TelnetInterrupt");
    try (Socket socket = connect();
        BufferedReader in = reader(socket)) {
      send(socket, "echo(1);\n");
      endsWith(in, "*** 1");
      socket.getOutputStream().write(INTERRUPT);
      endsWith(
          in,
          "!!! internal error: java.lang.NoClassDefFoundError: org/urbi/server/net/TelnetInterrupt");
      send(socket, "echo(2);\n");
      endsWith(in, "*** 2");
      send(socket, "shutdown;\n");
      Programs.Run run = server.get();
      assertEquals(0, run.status());
      assertTrue(run.log().contains("internal error in the connection of "), run::log);
      assertTrue(run.log().contains("\tat org.urbi.server.net.TelnetDecoder"), run::log);
    }
  }

  @Test
  void clientWithoutLobbyGetsTheErrorAndTheServerContinues() throws Exception {
    CompletableFuture<Programs.Run> server = server("org.urbi.server.net.BinaryLiteralDetector");
    for (int i = 0; i < 2; i++) {
      try (Socket socket = connect();
          BufferedReader in = reader(socket)) {
        endsWith(
            in,
            "!!! internal error: java.lang.NoClassDefFoundError: org/urbi/server/net/BinaryLiteralDetector");
        assertEquals(null, in.readLine());
      }
    }
    assertTrue(!server.isDone());
  }
}

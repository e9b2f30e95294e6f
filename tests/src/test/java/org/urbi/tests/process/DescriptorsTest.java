package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A server whose file descriptors run out goes on, and lets clients in when there are some again.
 */
class DescriptorsTest {
  private static final int DESCRIPTORS = 100;

  @Test
  void clientsBeyondTheDescriptorLimitAreRefusedAndOthersServed(@TempDir Path folder)
      throws Exception {
    try (ServerProcess server =
        ServerProcess.in(JavaProcess.Setting.in(folder).after("ulimit -n " + DESCRIPTORS))) {
      List<Socket> crowd = new ArrayList<>();
      try (Judge judge = Judge.of(server)) {
        for (int round = 0; round < 3; round++) {
          int refused = 0;
          for (int i = 0; i < DESCRIPTORS; i++) {
            Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
            crowd.add(socket);
          }
          for (Socket socket : crowd) {
            refused += isServed(socket) ? 0 : 1;
          }
          if (refused == 0) {
            throw new AssertionError("the descriptors have not run out");
          }
          judge.isAnswered("descriptors that have run out");
          for (Socket socket : crowd) {
            socket.close();
          }
          crowd.clear();
          // Those that are gone leave their descriptors when the server has noticed.
          while (!isServedOnce(server.port())) {
            judge.isAnswered("descriptors that come back");
          }
        }
      } finally {
        for (Socket socket : crowd) {
          socket.close();
        }
      }
      server.awaitText("clients are refused from now on: ");
      assertEquals(0, server.shutDown());
    }
  }

  private static boolean isServedOnce(int port) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      return isServed(socket);
    }
  }

  /** Whether it is answered; the other clients get a line that says why not, or a reset. */
  private static boolean isServed(Socket socket) throws IOException {
    try {
      socket.getOutputStream().write("echo(42);\n".getBytes(StandardCharsets.ISO_8859_1));
      var in = new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1);
      return new BufferedReader(in).lines().anyMatch(line -> line.endsWith("*** 42"));
    } catch (SocketException | UncheckedIOException e) {
      return false;
    }
  }
}

package org.urbi.server.tools;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class UrbiSendTest {
  private static Captured send(String... args) {
    return Captured.of(UrbiSend::run, args);
  }

  @Test
  void everythingIsSentInOrder(@TempDir Path folder) throws Exception {
    Path file = Files.writeString(folder.resolve("two.u"), "var two = 2;");
    try (ScriptedServer server = new ScriptedServer(line -> line.equals("quit;") ? null : "")) {
      Captured run =
          send(
              "-P" + server.port(),
              "--expression=var one = 1;\n",
              "-f",
              file.toString(),
              "--module",
              "machine",
              "-e",
              "one + two;\n",
              "--quit");
      assertEquals(new Captured(0, "", ""), run);
      assertEquals("var one = 1;", server.received());
      assertEquals("//#push 1 \"" + file + "\"", server.received());
      assertEquals("var two = 2;", server.received());
      assertEquals("//#pop", server.received());
      assertEquals("loadModule(\"machine\");", server.received());
      assertEquals("one + two;", server.received());
      assertEquals("quit;", server.received());
    }
  }

  @Test
  void answersAreShownUntilTheServerHangsUp() throws Exception {
    try (ScriptedServer server =
        new ScriptedServer(line -> line.startsWith("1") ? "[00000001] 1\n" : null)) {
      Captured run = send("-P" + server.port(), "-e", "1;\n2;\n");
      assertEquals(0, run.status());
      assertEquals("[00000001] 1\n", run.out());
      assertTrue(run.err().contains("Ctrl-C"), run.err());
    }
  }

  @Test
  void thePortMayBeInAFile(@TempDir Path folder) throws Exception {
    try (ScriptedServer server = new ScriptedServer(line -> null)) {
      Path file = Files.writeString(folder.resolve("port"), server.port() + "\n");
      assertEquals(new Captured(0, "", ""), send("--port-file", file.toString(), "-Q"));
    }
  }

  @Test
  void aServerThatIsNotThereIsSaid() throws IOException {
    int port;
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = free.getLocalPort();
    }
    Captured run = send("-P" + port, "-e", "1;");
    assertEquals(1, run.status());
    assertTrue(run.err().contains("cannot connect to 127.0.0.1:" + port), run.err());
  }

  @Test
  void aPortFileThatIsNotThereIsSaid() {
    Captured run = send("--port-file", "no/such/file");
    assertEquals(1, run.status());
    assertTrue(run.err().contains("no/such/file"), run.err());
  }

  @Test
  void aMissingFileIsSaidBeforeAnythingIsSent() {
    Captured run = send("-P1", "-f", "no/such.u");
    assertEquals(new Captured(1, "", "urbi-send: no such file: no/such.u\n"), run);
  }
}

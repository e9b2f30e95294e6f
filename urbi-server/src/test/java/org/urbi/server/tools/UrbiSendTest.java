package org.urbi.server.tools;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;

class UrbiSendTest {
  /** Nobody listens there: the system gives it to no program that asks for any port. */
  private static final int NOBODY = 1;

  private static ToolResult send(String... args) {
    return ToolResult.of(UrbiSend::run, args);
  }

  @Test
  void everythingIsSentInOrder(@TempDir Path folder) throws Exception {
    Path file = Files.writeString(folder.resolve("two.u"), "var two = 2;");
    try (ScriptedServer server = new ScriptedServer(line -> line.equals("quit;") ? null : "")) {
      ToolResult run =
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
      assertEquals(new ToolResult(0, "", ""), run);
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
      ToolResult run = send("-P" + server.port(), "-e", "1;\n2;\n");
      assertEquals(0, run.status());
      assertEquals("[00000001] 1\n", run.out());
      assertTrue(run.err().contains("Ctrl-C"), run.err());
    }
  }

  @Test
  void thePortMayBeInAFile(@TempDir Path folder) throws Exception {
    try (ScriptedServer server = new ScriptedServer(line -> null)) {
      Path file = Files.writeString(folder.resolve("port"), server.port() + "\n");
      assertEquals(new ToolResult(0, "", ""), send("--port-file", file.toString(), "-Q"));
    }
  }

  @Test
  void theServerMayBeWaitedFor(@TempDir Path folder) throws Exception {
    Path file = Files.writeString(folder.resolve("port"), "");
    var run = new AtomicReference<ToolResult>();
    Thread tool =
        Thread.ofPlatform()
            .start(() -> run.set(send("--wait=10min", "--port-file", file.toString(), "-Q")));
    while (tool.getState() != Thread.State.TIMED_WAITING) {
      Thread.onSpinWait();
    }
    try (ScriptedServer server = new ScriptedServer(line -> null)) {
      Files.writeString(file, server.port() + "\n");
      tool.join();
      assertEquals("quit;", server.received());
    }
    assertEquals(new ToolResult(0, "", ""), run.get());
  }

  @Test
  void thePortOfAServerThatHasEndedIsNotBelievedForEver(@TempDir Path folder) throws Exception {
    Path file = Files.writeString(folder.resolve("port"), NOBODY + "\n");
    ToolResult once = send("--port-file", file.toString(), "-Q");
    assertEquals(1, once.status());
    assertTrue(once.err().contains("the port is from " + file), once.err());
    var run = new AtomicReference<ToolResult>();
    Thread tool =
        Thread.ofPlatform()
            .start(() -> run.set(send("--wait=10min", "--port-file", file.toString(), "-Q")));
    while (tool.getState() != Thread.State.TIMED_WAITING) {
      Thread.onSpinWait();
    }
    try (ScriptedServer server = new ScriptedServer(line -> null)) {
      Files.writeString(file, server.port() + "\n");
      tool.join();
      assertEquals("quit;", server.received());
    }
    assertEquals(new ToolResult(0, "", ""), run.get());
  }

  @Test
  void aServerThatNeverComesIsReportedWhenTheTimeIsOver(@TempDir Path folder) {
    String file = folder.resolve("port").toString();
    ToolResult run = send("--wait=1ms", "--port-file", file, "-Q");
    assertEquals(1, run.status());
    assertTrue(run.err().contains("cannot read the port file " + file), run.err());
  }

  @Test
  void missingServerIsReported() {
    ToolResult run = send("-P" + NOBODY, "-e", "1;");
    assertEquals(1, run.status());
    assertTrue(run.err().contains("cannot connect to 127.0.0.1:" + NOBODY), run.err());
  }

  @Test
  void missingPortFileIsReported() {
    ToolResult run = send("--port-file", "no/such/file");
    assertEquals(1, run.status());
    assertTrue(run.err().contains("no/such/file"), run.err());
  }

  @Test
  void missingFileIsReportedBeforeAnythingIsSent() {
    ToolResult run = send("-P1", "-f", "no/such.u");
    assertEquals(new ToolResult(1, "", "urbi-send: no such file: no/such.u\n"), run);
  }

  @Test
  void codeThatHoldsTheServerCanBeInterrupted() throws Exception {
    Kernel kernel = Kernel.builder().maxHold(Duration.ofHours(1)).log(line -> {}).start();
    try (ConsoleServer server =
            new ConsoleServer(
                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                client -> kernel.connect(client, false),
                Limits.DEFAULT,
                new Trace(Trace.Level.NONE, System.err));
        Socket client = new Socket(InetAddress.getLoopbackAddress(), server.port())) {
      ToolResult nobody = send("-P" + server.port(), "--interrupt");
      assertEquals(new ToolResult(1, "nobody holds the kernel\n", ""), nobody);
      for (String lobby : List.of("", "Lobby_1")) {
        client.getOutputStream().write("while| (true) {};\n".getBytes(US_ASCII));
        client.getOutputStream().flush();
        ToolResult run;
        do {
          run = send("-P" + server.port(), "--interrupt", lobby);
        } while (run.out().startsWith("nobody"));
        assertEquals(0, run.status(), run.out());
        assertTrue(run.out().matches("interrupted: .*Lobby_1 \\(127.0.0.1\\).*\n"), run.out());
      }
      ToolResult unknown = send("-P" + server.port(), "--interrupt", "Lobby_0");
      assertEquals(1, unknown.status());
      // The clients that have asked before may not have left yet.
      assertTrue(
          unknown.out().matches("no such lobby: Lobby_0; there are (.*, )?Lobby_1 \\(.*\n"),
          unknown.out());
    } finally {
      kernel.close();
    }
  }
}

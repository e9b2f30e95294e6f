package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.server.Trace;

/** A kernel, the network console, and clients on real sockets. */
class ConsoleServerTest {
  private static final Trace QUIET =
      new Trace(
          Trace.Level.NONE,
          new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));

  private Kernel kernel;
  private ConsoleServer server;

  @BeforeEach
  void start() throws IOException {
    kernel = Kernel.builder().start();
    server = listen(0, Limits.DEFAULT);
  }

  @AfterEach
  void stop() {
    kernel.close();
    server.close();
  }

  private ConsoleServer listen(int port, Limits limits) throws IOException {
    return new ConsoleServer(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), port),
        client -> kernel.connect(client, false),
        limits,
        QUIET);
  }

  private TestClient client() throws IOException {
    return new TestClient(server.port());
  }

  @Test
  void eachClientHasALobbyAndAllShareTheGlobals() throws IOException {
    try (TestClient one = client();
        TestClient two = client()) {
      assertEquals("[] 1", one.ask("var own = 1; var Global.shared = 1 |;"));
      assertEquals("[] 1", two.ask("shared;"));
      assertEquals(
          "[:error] !!! 1.8-10: lookup failed: own (possible misspelling of tan)", two.ask("own;"));
    }
  }

  @Test
  void browserPageCannotRunCode() throws IOException {
    try (TestClient judge = client();
        TestClient page = client()) {
      page.send(
          "POST / HTTP/1.1\r\nHost: localhost\r\nOrigin: http://elsewhere\r\n\r\n"
              + "\n*/}])>;\n;var Global.taken = 1;\n");
      assertTrue(page.line().endsWith("which does not speak HTTP: closing"));
      assertNull(page.line());
      assertEquals(
          "[:error] !!! 1.1-5: lookup failed: taken (possible misspelling of tan)",
          judge.ask("taken;"));
    }
  }

  /** Those for whom the system has no room in its queue would try again after a second. */
  @Test
  void fiveHundredThatConnectAtOnceFindRoom() throws Exception {
    CountDownLatch deaf = new CountDownLatch(1);
    try (ConsoleServer busy =
        new ConsoleServer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            client -> {
              try {
                deaf.await();
              } catch (InterruptedException e) {
                throw new IllegalStateException(e);
              }
              return kernel.connect(client, false);
            },
            Limits.DEFAULT,
            QUIET)) {
      List<TestClient> clients = new ArrayList<>();
      for (int i = 0; i < 500; i++) {
        // Nobody accepts them: the next would wait for ever if the queue were full.
        clients.add(new TestClient(busy.port()));
      }
      deaf.countDown();
      for (TestClient each : clients) {
        each.send("1;");
      }
      for (TestClient each : clients) {
        assertEquals("[] 1", each.line());
        each.close();
      }
    }
  }

  @Test
  void clientsAreLimitedAndPlacesBecomeFree() throws Exception {
    try (ConsoleServer small = listen(0, Limits.DEFAULT.withConnections(2));
        TestClient one = new TestClient(small.port())) {
      assertEquals("[] 1", one.ask("1;"));
      TestClient two = new TestClient(small.port());
      assertEquals("[] 2", two.ask("2;"));
      try (TestClient third = new TestClient(small.port())) {
        assertEquals("[:error] !!! this server takes 2 clients at most: closing", third.line());
        assertNull(third.line());
      }
      assertEquals("[] 3", one.ask("3;"));
      two.close();
      String answer = null;
      while (!"[] 4".equals(answer)) {
        try (TestClient later = new TestClient(small.port())) {
          answer = later.ask("4;");
        }
      }
    }
  }

  @Test
  void statementMayBeCutAnywhere() throws IOException {
    try (TestClient client = client()) {
      for (char c : "echo(\"cut\" + 1".toCharArray()) {
        client.send(String.valueOf(c));
      }
      assertEquals("[] *** cut1", client.ask(");"));
    }
  }

  @Test
  void bytesComeBackAsTheyWereSent() throws IOException {
    try (TestClient client = client()) {
      assertEquals("[] *** \u00c3\u00a9\u00fe", client.ask("echo(\"\u00c3\u00a9\u00fe\");"));
    }
  }

  @Test
  void allOutputArrivesBeforeTheConnectionIsClosed() throws IOException {
    try (TestClient client = client()) {
      client.send("for| (var i = 0; i < 1000; i += 1) echo(i); quit; echo(\"never\");\n");
      for (int i = 0; i < 1000; ++i) {
        assertEquals("[] *** " + i, client.line());
      }
      assertNull(client.line());
    }
  }

  @Test
  void clientThatEndsItsInputStillGetsAnswers() throws IOException {
    try (TestClient client = client()) {
      client.send("echo(0), for (100) {}; echo(1) & echo(2); 3;");
      client.end();
      assertEquals("[] *** 0", client.line());
      assertEquals("[] *** 1", client.line());
      assertEquals("[] *** 2", client.line());
      assertEquals("[] 3", client.line());
      assertNull(client.line());
    }
  }

  @Test
  void aLobbyKnowsTheAddressOfItsClient() throws IOException {
    try (TestClient client = client()) {
      assertEquals("[] \"127.0.0.1\"", client.ask("lobby.remoteIP;"));
    }
  }

  @Test
  void jobsOfAClientThatEndsItsInputEnd() throws Exception {
    List<String> programs =
        List.of(
            "every (1ms) Global.beats++,",
            "every| (1ms) Global.beats++; echo(\"never\");",
            "loop Global.beats++, sleep(1h); echo(\"never\");",
            "loop { Global.beats++; sleep(1ms) }; echo(\"never\");",
            "detach({ loop Global.beats++ })|; waituntil(false); echo(\"never\");",
            "at (true) loop Global.beats++; lobby.connectionTag.freeze; echo(\"never\");");
    try (TestClient witness = client()) {
      witness.ask("var Global.beats = 0;");
      for (String program : programs) {
        try (TestClient client = client()) {
          client.send(program);
          client.end();
          assertNull(client.line(), program);
        }
        String before = witness.ask("beats;");
        assertEquals(before, witness.ask("sleep(20ms); beats;"), program);
      }
    }
  }

  @Test
  void theJobsOfAClientThatVanishesEnd() throws IOException {
    try (TestClient witness = client()) {
      assertEquals("[] 0", witness.ask("var Global.beats = 0;"));
      TestClient client = client();
      assertEquals(
          "[] *** beating",
          client.ask("every (1ms) Global.beats += 1, sleep(5ms); echo(\"beating\");"));
      client.vanish();
      String before = null;
      String now = witness.ask("beats;");
      while (!now.equals(before)) {
        before = now;
        now = witness.ask("sleep(20ms); beats;");
      }
    }
  }

  @Test
  void clientThatDoesNotReadDisturbsNobody() throws IOException {
    try (ConsoleServer strict = listen(0, new Limits(1 << 20, 1 << 16, 1 << 20, 30, 0, ""));
        TestClient deaf = new TestClient(strict.port());
        TestClient other = new TestClient(strict.port())) {
      deaf.send("var line = \"x\" * 10000; loop { echo(line); };\n");
      assertEquals("[] *** hello", other.ask("echo(\"hello\");"));
      String line = "";
      while (line != null) {
        assertEquals("[] 2", other.ask("1 + 1;"));
        line = readOrNull(deaf);
      }
      assertEquals("[] 3", other.ask("1 + 2;"));
    }
  }

  /** Reads a little, as slowly as the test asks; null once the server has hung up. */
  private static String readOrNull(TestClient client) {
    try {
      return client.line();
    } catch (IOException reset) {
      return null;
    }
  }

  @Test
  void telnetClientsMayInterrupt() throws IOException {
    try (TestClient client = client()) {
      assertEquals("[] *** busy", client.ask("echo(\"busy\"); sleep(inf); echo(\"never\");"));
      assertEquals(
          "[:error] !!! received interruption, killing foreground job.",
          client.ask("\u00ff\u00f4"));
      assertEquals("[] *** next", client.ask("echo(\"next\");"));
    }
  }

  @Test
  void shutdownSaysGoodbyeToEverybody() throws IOException {
    try (TestClient one = client();
        TestClient two = client()) {
      assertEquals("[] 1", one.ask("1;"));
      assertEquals("[] 1", two.ask("1;"));
      one.send("shutdown(7);");
      assertNull(one.line());
      assertNull(two.line());
      assertEquals(7, kernel.awaitTermination());
    }
  }

  @Test
  void portInUseIsReported() {
    IOException failure =
        assertThrows(IOException.class, () -> listen(server.port(), Limits.DEFAULT));
    assertTrue(failure.getMessage().contains(":" + server.port()), failure.getMessage());
  }
}

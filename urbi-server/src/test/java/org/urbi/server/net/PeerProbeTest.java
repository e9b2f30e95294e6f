package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Trace;
import org.urbi.server.trust.AccessPolicy;

/**
 * Clients that leave in the ordinary way while their code holds a kernel whose limit for that is
 * out of sight: another client would never be answered. By whatever way they have come, that is
 * noticed.
 */
class PeerProbeTest {
  private static final String HOLD = "while| (true) {};";

  /** Longer than the probe takes to look and to ask. */
  private static final String COMPUTE =
      "var begin = time | while| (time - begin < 0.3) {} | \"still here\";";

  private static final Trace QUIET =
      new Trace(
          Trace.Level.NONE,
          new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));

  @TempDir static Path shared;
  private static TestIdentity identity;

  @TempDir Path folder;
  private final List<ConsoleServer> servers = new ArrayList<>();
  private Kernel kernel;

  /** Where the client comes who is to be answered. */
  private ConsoleServer server;

  @BeforeAll
  static void makeIdentity() {
    identity = TestIdentity.make(shared, "own");
  }

  @BeforeEach
  void start() throws IOException {
    kernel = Kernel.builder().start();
    server = listen(AccessPolicy.ALL);
  }

  private ConsoleServer listen(AccessPolicy policy) throws IOException {
    ConsoleServer made =
        new ConsoleServer(
            client -> kernel.connect(client, false),
            kernel::connectRemote,
            new Limits(1 << 16, 1 << 20, 1 << 24, 1 << 20, 0, ""),
            policy,
            QUIET);
    servers.add(made);
    made.listen(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
    return made;
  }

  @AfterEach
  void stop() {
    kernel.close();
    servers.forEach(ConsoleServer::close);
  }

  private TestClient client() throws IOException {
    return new TestClient(server.port());
  }

  private Visitor visitor(Visitor.Way way) throws Exception {
    ConsoleServer guarded =
        listen(
            new AccessPolicy(
                way.tokens(),
                way.tokens() == null ? Role.OWNER : null,
                way.tls ? identity.read() : null));
    Path socket = folder.resolve("console");
    guarded.listen(socket, PosixFilePermissions.fromString("rw-------"));
    return Visitor.come(way, guarded.port(), socket, identity);
  }

  @ParameterizedTest
  @EnumSource(Visitor.Way.class)
  void whoeverHasReadAllAndClosesHasLeft(Visitor.Way way) throws Exception {
    try (TestClient judge = client()) {
      Visitor leaving = visitor(way);
      assertEquals("[] 1", leaving.ask("1;"));
      leaving.send(HOLD);
      leaving.close();
      assertEquals("[] 1", judge.ask("1;"));
    }
  }

  /** The system of that client sends what waits when nobody could read an answer any more. */
  @ParameterizedTest
  @EnumSource(Visitor.Way.class)
  void whoeverClosesWhileTheServerDoesNotReadHasLeft(Visitor.Way way) throws Exception {
    try (TestClient judge = client()) {
      Visitor leaving = visitor(way);
      assertEquals("[] 1", leaving.ask("1;"));
      leaving.send(HOLD + "1".repeat(1 << 17));
      leaving.close();
      assertEquals("[] 1", judge.ask("1;"));
    }
  }

  /** What is still in transit when it closes is answered by a reset, or never read. */
  @ParameterizedTest
  @EnumSource(Visitor.Way.class)
  void whoeverClosesWithoutReadingTheAnswersHasLeft(Visitor.Way way) throws Exception {
    try (TestClient judge = client()) {
      Visitor leaving = visitor(way);
      assertEquals("[] 1", leaving.ask("1;"));
      leaving.send("for| (100) echo(\"unread\");");
      assertEquals("[] *** unread", leaving.line());
      leaving.send(HOLD);
      leaving.close();
      assertEquals("[] 1", judge.ask("1;"));
    }
  }

  /** Telnet's questions come in between, and are not taken for a sign of life. */
  @ParameterizedTest
  @EnumSource(
      value = Visitor.Way.class,
      names = {"TELNET", "SOCKET_AND_TELNET", "TLS_AND_TOKEN"})
  void whoeverAsksTelnetsQuestionsAndClosesHasLeft(Visitor.Way way) throws Exception {
    try (TestClient judge = client()) {
      Visitor leaving = visitor(way);
      assertEquals("[] 1", leaving.ask("1;"));
      leaving.send(HOLD);
      leaving.send("\u00ff\u00f6".repeat(1 << 10));
      leaving.close();
      assertEquals("[] 1", judge.ask("1;"));
    }
  }

  /** The kernel has no time for it until the one who holds it lets others run. */
  @Test
  void whatWasSentBeforeIsExecutedThoughTheKernelWasBusy() throws IOException {
    try (TestClient busy = client();
        TestClient judge = client()) {
      assertEquals("[] 1", busy.ask("1;"));
      TestClient leaving = client();
      assertEquals("[] 1", leaving.ask("1;"));
      busy.send(COMPUTE);
      leaving.send("var Global.done = 2 | nil;");
      leaving.close();
      assertEquals("[] \"still here\"", busy.line());
      assertEquals("[] 2", judge.ask("waituntil (Global.hasSlot(\"done\")) | done;"));
    }
  }

  @ParameterizedTest
  @EnumSource(Visitor.Way.class)
  void whoeverOnlySendsNoMoreGetsTheAnswerAndNothingElse(Visitor.Way way) throws Exception {
    try (Visitor waiting = visitor(way)) {
      waiting.send(COMPUTE);
      waiting.end();
      assertEquals("[] \"still here\"", waiting.line());
      assertNull(waiting.line());
    }
  }
}

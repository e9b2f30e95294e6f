package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.server.Trace;
import org.urbi.server.trust.AccessPolicy;

/**
 * Clients that leave in the ordinary way while their code holds a kernel whose limit for that is
 * out of sight: another client would never be answered.
 */
class PeerProbeTest {
  private static final String HOLD = "while| (true) {};";

  /** Longer than the probe takes to look and to ask. */
  private static final String COMPUTE =
      "var begin = time | while| (time - begin < 0.3) {} | \"still here\";";

  @TempDir Path folder;
  private Kernel kernel;
  private ConsoleServer server;

  @BeforeEach
  void start() throws IOException {
    kernel = Kernel.builder().start();
    server =
        new ConsoleServer(
            client -> kernel.connect(client, false),
            null,
            new Limits(1 << 16, 1 << 20, 1 << 24, 1 << 20, 0, ""),
            AccessPolicy.ALL,
            new Trace(
                Trace.Level.NONE,
                new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8)));
    server.listen(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
    server.listen(folder.resolve("console"), PosixFilePermissions.fromString("rw-------"));
  }

  @AfterEach
  void stop() {
    kernel.close();
    server.close();
  }

  private TestClient client() throws IOException {
    return new TestClient(server.port());
  }

  private SocketChannel local() throws IOException {
    return SocketChannel.open(UnixDomainSocketAddress.of(folder.resolve("console")));
  }

  private static ByteBuffer bytes(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  @Test
  void whoeverHasReadAllAndClosesHasLeft() throws IOException {
    try (TestClient judge = client()) {
      TestClient leaving = client();
      assertEquals("[] 1", leaving.ask("1;"));
      leaving.send(HOLD);
      leaving.close();
      assertEquals("[] 1", judge.ask("1;"));
    }
  }

  /** The system of that client sends what waits when nobody could read an answer any more. */
  @Test
  void whoeverClosesWhileTheServerDoesNotReadHasLeft() throws IOException {
    try (TestClient judge = client()) {
      TestClient leaving = client();
      assertEquals("[] 1", leaving.ask("1;"));
      leaving.send(HOLD + "1".repeat(1 << 17));
      leaving.close();
      assertEquals("[] 1", judge.ask("1;"));
    }
  }

  @Test
  void whoeverClosesALocalSocketHasLeft() throws IOException {
    try (TestClient judge = client()) {
      SocketChannel leaving = local();
      leaving.write(bytes("1;"));
      leaving.read(ByteBuffer.allocate(100));
      leaving.write(bytes(HOLD));
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

  @Test
  void whoeverOnlySendsNoMoreGetsTheAnswerAndNothingElse() throws IOException {
    try (TestClient waiting = client()) {
      waiting.send(COMPUTE);
      waiting.end();
      assertEquals("[] \"still here\"", waiting.line());
      assertNull(waiting.line());
    }
  }

  @Test
  void whoeverOnlySendsNoMoreToALocalSocketGetsTheAnswer() throws IOException {
    try (SocketChannel waiting = local()) {
      waiting.write(bytes(COMPUTE));
      waiting.shutdownOutput();
      ByteBuffer answer = ByteBuffer.allocate(100);
      while (waiting.read(answer) >= 0) {
        // There is more.
      }
      String text = new String(answer.array(), 0, answer.position(), StandardCharsets.ISO_8859_1);
      assertEquals("still here\"\n", text.substring(text.indexOf("still")));
    }
  }
}

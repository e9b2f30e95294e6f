package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.embedded.EmbeddedChannel;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import javax.net.ssl.SSLSocket;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.trust.Role;
import org.urbi.server.TestTimeout;
import org.urbi.server.Trace;
import org.urbi.server.tools.ToolResult;
import org.urbi.server.tools.UrbiSend;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.ServerIdentity;
import org.urbi.server.trust.Tokens;
import urbi.ServerConnection;
import urbi.TokenLine;
import urbi.UClientException;
import urbi.USyncClient;
import urbi.remote.RemoteContext;
import urbi.rtp.RtpOptions;

/** A server that speaks TLS, and those who do not, or not as they should. */
class TlsTest {
  private static final Trace QUIET =
      new Trace(
          Trace.Level.NONE,
          new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));

  /** A record that promises more of a handshake than ever comes. */
  private static final byte[] HALF_A_HANDSHAKE = {22, 3, 1, 2, 0, 1, 0, 1, (byte) 0xfc, 3, 3};

  @TempDir static Path folder;
  private static TestIdentity own;

  private final AtomicInteger lobbies = new AtomicInteger();
  private Kernel kernel;
  private ConsoleServer server;

  @BeforeAll
  static void makeIdentity() {
    own = TestIdentity.make(folder, "own");
  }

  @BeforeEach
  void start() throws IOException {
    kernel = Kernel.builder().log(line -> {}).start();
    listen(own.read(), null, Limits.DEFAULT);
  }

  private void listen(ServerIdentity identity, Tokens tokens, Limits limits) throws IOException {
    if (server != null) {
      server.close();
    }
    Role otherwise = tokens == null ? Role.OWNER : null;
    server =
        new ConsoleServer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            client -> {
              lobbies.incrementAndGet();
              return kernel.connect(client, false);
            },
            kernel::connectRemote,
            limits,
            new AccessPolicy(tokens, otherwise, identity),
            QUIET);
    ServerConnection.trust(own.certificate().toString());
  }

  @AfterEach
  void stop() {
    System.clearProperty(ServerConnection.TLS_PROPERTY);
    System.clearProperty(ServerConnection.TLS_CA_PROPERTY);
    System.clearProperty(TokenLine.PROPERTY);
    server.close();
    kernel.close();
  }

  private USyncClient client() {
    USyncClient client = USyncClient.connect("localhost", server.port(), TestTimeout.LONG);
    client.setDefaultTimeout(TestTimeout.LONG);
    return client;
  }

  private void assertServes() {
    try (USyncClient client = client()) {
      assertEquals(3, client.syncEval("1+2").intValue());
    }
  }

  private String refusal() {
    return assertThrows(UClientException.class, () -> client().close()).getMessage();
  }

  private Socket socket() throws IOException {
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
    socket.setSoTimeout((int) TestTimeout.LONG.toMillis());
    return socket;
  }

  private static void send(Socket socket, String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  private static List<String> lines(Socket socket) throws IOException {
    return new BufferedReader(
            new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1))
        .lines()
        .map(line -> line.replaceFirst("^\\[\\d+] ", ""))
        .toList();
  }

  // ------------------------------------------------------------------ a good day

  @Test
  void clientsAreServed() {
    assertServes();
    assertEquals(1, lobbies.get());
  }

  @Test
  void muchGoesThroughWhole() {
    try (USyncClient client = client()) {
      assertEquals(
          300_001,
          client.syncEval("\"" + "x".repeat(300_000) + "\" + \"y\"").stringValue().length());
    }
  }

  @Test
  void aClientThatEndsItsStreamStillGetsItsAnswers() throws Exception {
    try (SSLSocket client = own.secure(socket())) {
      send(client, "for (300) {}; 6*7;");
      client.shutdownOutput();
      assertEquals(List.of("42"), lines(client));
    }
    assertServes();
  }

  @Test
  void whatWasSentBeforeTheGoodbyeArrives() throws Exception {
    try (SSLSocket client = own.secure(socket())) {
      send(client, "\"x\" * 300000; 1; quit;");
      List<String> lines = lines(client);
      assertEquals(300_002, lines.getFirst().length());
      assertEquals("1", lines.get(1));
    }
  }

  @Test
  void tokensGoByTls() throws IOException {
    Path file = Files.writeString(folder.resolve("tokens"), "owner owner-0123456789 boss\n");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
    listen(own.read(), Tokens.read(file), Limits.DEFAULT);
    System.setProperty(TokenLine.PROPERTY, "owner-0123456789");
    assertServes();
    System.setProperty(TokenLine.PROPERTY, "wrong-0123456789");
    assertThrows(UClientException.class, this::assertServes);
  }

  @Test
  void remoteProcessesAreServedAndDatagramsAreNot() throws Exception {
    StringBuilder told = new StringBuilder();
    try (RemoteContext remote = new RemoteContext("localhost", server.port());
        USyncClient client = client()) {
      remote.onOutput(text -> told.append(new String(text, StandardCharsets.UTF_8)));
      client.syncEval("loadModule(\"urbi/rtp\")");
      assertFalse(
          remote.useRtp(RtpOptions.DEFAULT).get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS));
      assertEquals(3, client.syncEval("1+2").intValue());
    }
  }

  @Test
  void toolsSpeakIt() {
    stop();
    try {
      start();
    } catch (IOException e) {
      throw new AssertionError(e);
    }
    System.clearProperty(ServerConnection.TLS_PROPERTY);
    System.clearProperty(ServerConnection.TLS_CA_PROPERTY);
    String port = "--port=" + server.port();
    ToolResult without = ToolResult.of(UrbiSend::run, port, "-Q", "-e", "1+2;");
    assertTrue(without.out().contains("speaks TLS alone (--tls"), without.out());
    ToolResult stranger = ToolResult.of(UrbiSend::run, port, "--tls", "-Q", "-e", "1+2;");
    assertEquals(1, stranger.status());
    assertTrue(stranger.err().contains("not trusted"), stranger.err());
    ToolResult run =
        ToolResult.of(UrbiSend::run, port, "--tls-ca=" + own.certificate(), "-Q", "-e", "1+2;");
    assertEquals("", run.err());
    assertTrue(run.out().endsWith("] 3\n"), run.out());
    assertEquals(0, run.status());
  }

  // ------------------------------------------------------------------ bad clients

  @Test
  void aPlainClientIsToldAndLetGo() throws IOException {
    try (TestClient plain = new TestClient(server.port())) {
      plain.send("var Global.taken = 1;\n");
      assertTrue(plain.line().contains("this server speaks TLS alone"));
      assertNull(plain.line());
    }
    assertServes();
    assertEquals(1, lobbies.get());
  }

  @Test
  void garbageIsNoHandshake() throws Exception {
    Random random = new Random(1);
    for (int i = 0; i < 50; i++) {
      byte[] garbage = new byte[1 + random.nextInt(3000)];
      random.nextBytes(garbage);
      garbage[0] = 22;
      try (Socket client = socket()) {
        client.getOutputStream().write(garbage);
        client.shutdownOutput();
        client.getInputStream().transferTo(OutputStream.nullOutputStream());
      } catch (IOException e) {
        // A reset is as good as an end.
      }
    }
    assertServes();
    assertEquals(1, lobbies.get());
  }

  @Test
  void garbageAfterTheHandshakeEndsTheConnectionAlone() throws Exception {
    try (Socket plain = socket()) {
      SSLSocket client = own.secure(plain);
      send(client, "1;");
      plain
          .getOutputStream()
          .write("no record at all of any kind".getBytes(StandardCharsets.US_ASCII));
      plain.getInputStream().transferTo(OutputStream.nullOutputStream());
    } catch (IOException e) {
      // A reset is as good as an end.
    }
    assertServes();
  }

  @Test
  void handshakesThatStopHalfwayHoldNobodyUp() throws IOException {
    List<Socket> halves = new ArrayList<>();
    for (int i = 0; i < 100; i++) {
      Socket half = socket();
      half.getOutputStream().write(HALF_A_HANDSHAKE);
      halves.add(half);
    }
    assertServes();
    for (Socket half : halves) {
      half.setSoLinger(true, 0);
      half.close();
    }
    assertServes();
    assertEquals(2, lobbies.get());
  }

  @Test
  void othersAreServedDuringAFloodOfHandshakes() throws Exception {
    try (USyncClient judge = client();
        var flood = Executors.newVirtualThreadPerTaskExecutor()) {
      List<Future<?>> all = new ArrayList<>();
      for (int i = 0; i < 40; i++) {
        all.add(
            flood.submit(() -> {
              try (SSLSocket client = own.secure(socket())) {
                return client.isConnected();
              }
            }));
      }
      for (int i = 0; i < 10; i++) {
        assertEquals(i, judge.syncEval(String.valueOf(i)).intValue());
      }
      for (Future<?> each : all) {
        assertEquals(true, each.get());
      }
    }
    assertServes();
  }

  @Test
  void aHandshakeTakesAPlaceAndGivesItBack() throws Exception {
    listen(own.read(), null, Limits.DEFAULT.withConnections(1));
    Socket half = socket();
    half.getOutputStream().write(HALF_A_HANDSHAKE);
    Thread.sleep(100);
    assertTrue(refusal().contains("or has no place for another client"));
    half.close();
    long end = System.nanoTime() + TestTimeout.LONG.toNanos();
    while (System.nanoTime() < end) {
      try {
        assertServes();
        return;
      } catch (UClientException e) {
        Thread.sleep(20);
      }
    }
    throw new AssertionError("the place is lost");
  }

  @Test
  void anEndWithoutAWordOfTlsIsALoss() throws Exception {
    try (Socket plain = socket()) {
      SSLSocket client = own.secure(plain);
      send(client, "echo(1);loop {};");
      int first = client.getInputStream().read();
      assertEquals('[', first);
      plain.shutdownOutput();
      // Within the time that a client has which ends its stream as it should.
      plain.setSoTimeout(Limits.DEFAULT.secondsAfterEnd() * 1000 - 5000);
      plain.getInputStream().transferTo(OutputStream.nullOutputStream());
    }
  }

  @Test
  void whoDoesNotReadIsLetGo() throws Exception {
    try (USyncClient judge = client()) {
      int others = judge.syncEval("lobbies.size").intValue();
      try (SSLSocket deaf = own.secure(socket())) {
        send(deaf, "var Global.deaf = 1|; loop { lobby.send(\"x\" * 100000)|; sleep(1ms) },");
        await(judge, "Global.hasSlot(\"deaf\")");
        await(judge, "lobbies.size == " + others);
      }
    }
  }

  private static void await(USyncClient judge, String condition) throws InterruptedException {
    long end = System.nanoTime() + TestTimeout.LONG.toNanos();
    while (!judge.syncEval(condition).booleanValue()) {
      assertTrue(System.nanoTime() < end, condition);
      Thread.sleep(50);
    }
  }

  // ------------------------------------------------------------------ in virtual time

  private static final class Inner extends ChannelInboundHandlerAdapter {
    private boolean active;

    @Override
    public void channelActive(ChannelHandlerContext context) {
      active = true;
    }
  }

  private EmbeddedChannel gate(Inner inner) throws IOException {
    EmbeddedChannel channel = new EmbeddedChannel();
    channel.freezeTime();
    channel.pipeline().addLast(new TlsGate(TlsGate.context(own.read()), QUIET), inner);
    channel.pipeline().fireChannelActive();
    return channel;
  }

  @Test
  void whoSaysNothingIsToldAndLetGo() throws IOException {
    Inner inner = new Inner();
    EmbeddedChannel channel = gate(inner);
    channel.advanceTimeBy(9, TimeUnit.SECONDS);
    channel.runScheduledPendingTasks();
    assertTrue(channel.isOpen());
    channel.advanceTimeBy(1, TimeUnit.SECONDS);
    channel.runScheduledPendingTasks();
    ByteBuf told = channel.readOutbound();
    assertTrue(told.toString(StandardCharsets.US_ASCII).contains("speaks TLS alone"));
    told.release();
    assertFalse(channel.isOpen());
    assertFalse(inner.active);
  }

  @Test
  void whoStopsHalfwayIsLetGo() throws IOException {
    Inner inner = new Inner();
    EmbeddedChannel channel = gate(inner);
    channel.writeInbound(Unpooled.wrappedBuffer(HALF_A_HANDSHAKE));
    assertFalse(inner.active);
    channel.advanceTimeBy(10, TimeUnit.SECONDS);
    channel.runScheduledPendingTasks();
    channel.advanceTimeBy(1, TimeUnit.SECONDS);
    channel.runScheduledPendingTasks();
    assertFalse(channel.isOpen());
    assertFalse(inner.active);
    channel.finishAndReleaseAll();
  }

  // ------------------------------------------------------------------ bad servers

  @Test
  void aForeignCertificateIsNotTrusted() throws IOException {
    ServerConnection.trust(TestIdentity.make(folder, "foreign").certificate().toString());
    String refusal = refusal();
    assertTrue(refusal.contains("not trusted"), refusal);
    assertTrue(refusal.contains("--tls-ca FILE"), refusal);
    assertEquals(0, lobbies.get());
  }

  @Test
  void aCertificateForAnotherNameIsNotTrusted() throws IOException {
    TestIdentity other = TestIdentity.make(folder, "other", "robot.example");
    listen(other.read(), null, Limits.DEFAULT);
    ServerConnection.trust(other.certificate().toString());
    String refusal = refusal();
    assertTrue(refusal.contains("certificate is for another name"), refusal);
    assertTrue(refusal.contains("localhost"), refusal);
  }

  @Test
  void anExpiredCertificateIsNotTrusted() throws IOException {
    TestIdentity expired = TestIdentity.expired(folder);
    ServerIdentity identity = expired.read();
    assertTrue(identity.warnings().getFirst().contains("has expired"));
    listen(identity, null, Limits.DEFAULT);
    ServerConnection.trust(expired.certificate().toString());
    String refusal = refusal();
    assertTrue(refusal.contains("has expired"), refusal);
  }

  @Test
  void aServerWithoutTlsIsSaid() throws IOException {
    listen(null, null, Limits.DEFAULT);
    String refusal = refusal();
    assertTrue(refusal.contains("has not answered in TLS"), refusal);
  }

  @Test
  void aServerThatSaysNothingIsNotWaitedForForEver() throws IOException {
    try (ServerSocket silent = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      IOException refusal =
          assertThrows(
              IOException.class,
              () -> ServerConnection.open("localhost", silent.getLocalPort(), 100));
      assertTrue(refusal.getMessage().contains("no answer in TLS"), refusal.getMessage());
    }
  }

  @Test
  void aFileThatIsNoCertificateIsSaid() throws IOException {
    ServerConnection.trust(folder.resolve("missing").toString());
    assertTrue(refusal().contains("cannot read the certificate to be trusted"), refusal());
    ServerConnection.trust(own.key().toString());
    assertTrue(refusal().contains("no certificate in PEM"), refusal());
  }
}

package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.trust.Role;
import org.urbi.server.TestTimeout;
import org.urbi.server.Trace;
import org.urbi.server.tools.ToolResult;
import org.urbi.server.tools.UrbiPing;
import org.urbi.server.tools.UrbiSend;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.Tokens;
import urbi.ServerConnection;
import urbi.UClientException;
import urbi.USyncClient;
import urbi.remote.RemoteContext;

/** A server with a Unix domain socket, what else its file may be, and who comes by it. */
class UnixSocketTest {
  private static final Trace QUIET =
      new Trace(
          Trace.Level.NONE,
          new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));

  private static final Set<PosixFilePermission> PRIVATE =
      PosixFilePermissions.fromString("rw-------");

  @TempDir Path folder;
  private Kernel kernel;
  private Path file;
  private final List<ConsoleServer> servers = new ArrayList<>();

  @BeforeEach
  void start() {
    kernel = Kernel.builder().log(line -> {}).start();
    file = folder.resolve("console");
  }

  @AfterEach
  void stop() {
    servers.forEach(ConsoleServer::close);
    kernel.close();
  }

  private ConsoleServer listen(AccessPolicy policy, Limits limits) throws IOException {
    ConsoleServer server =
        new ConsoleServer(
            client -> kernel.connect(client, false), kernel::connectRemote, limits, policy, QUIET);
    synchronized (servers) {
      servers.add(server);
    }
    server.listen(file, PRIVATE);
    return server;
  }

  private ConsoleServer listen() throws IOException {
    return listen(AccessPolicy.ALL, Limits.DEFAULT);
  }

  private String refusal() {
    return assertThrows(IOException.class, this::listen).getMessage();
  }

  private USyncClient client() {
    USyncClient client = USyncClient.connect(file.toString(), 0, TestTimeout.LONG);
    client.setDefaultTimeout(TestTimeout.LONG);
    return client;
  }

  private void assertServes() {
    try (USyncClient client = client()) {
      assertEquals(3, client.syncEval("1+2").intValue());
    }
  }

  private SocketChannel plain() throws IOException {
    return SocketChannel.open(UnixDomainSocketAddress.of(file));
  }

  private static void send(SocketChannel to, String text) throws IOException {
    to.write(ByteBuffer.wrap(text.getBytes(StandardCharsets.ISO_8859_1)));
  }

  private static List<String> lines(SocketChannel from) {
    return new BufferedReader(
            new InputStreamReader(Channels.newInputStream(from), StandardCharsets.ISO_8859_1))
        .lines()
        .map(line -> line.replaceFirst("^\\[\\d+(:?[^]]*)] ", "[$1] "))
        .toList();
  }

  private ServerSocketChannel bound(int backlog) throws IOException {
    return ServerSocketChannel.open(StandardProtocolFamily.UNIX)
        .bind(UnixDomainSocketAddress.of(file), backlog);
  }

  private List<Path> files() throws IOException {
    try (var all = Files.list(folder)) {
      return all.toList();
    }
  }

  // ------------------------------------------------------------------ the file

  @Test
  void theFileIsPrivateAndAloneAndGoesWithTheServer() throws IOException {
    ConsoleServer server = listen();
    assertEquals(PRIVATE, Files.getPosixFilePermissions(file));
    assertEquals(List.of(file), files());
    assertServes();
    server.close();
    assertEquals(List.of(), files());
  }

  @Test
  void whatIsNoSocketStaysAsItIs() throws IOException {
    Files.writeString(file, "precious");
    assertTrue(refusal().endsWith("it is there, and is no socket"), refusal());
    assertEquals("precious", Files.readString(file));
    Files.delete(file);
    Files.createDirectory(file);
    assertTrue(refusal().endsWith("it is there, and is no socket"), refusal());
    Files.delete(file);
    Files.createSymbolicLink(file, folder.resolve("elsewhere"));
    assertTrue(refusal().endsWith("it is there, and is no socket"), refusal());
    assertEquals(List.of(file), files());
  }

  @Test
  void theSocketOfAServerThatHasGoneIsReplaced() throws IOException {
    bound(1).close();
    assertTrue(Files.exists(file));
    listen();
    assertServes();
    assertEquals(List.of(file), files());
  }

  @Test
  void theSocketOfALiveServerIsRefused() throws IOException {
    listen();
    assertTrue(refusal().endsWith("a server listens there already"), refusal());
    assertServes();
    assertEquals(List.of(file), files());
  }

  @Test
  void aServerThatAnswersNobodyIsAlive() throws IOException {
    try (ServerSocketChannel frozen = bound(1)) {
      List<SocketChannel> waiting = new ArrayList<>();
      assertThrows(
          SocketException.class,
          () -> {
            while (true) {
              SocketChannel next = SocketChannel.open(StandardProtocolFamily.UNIX);
              waiting.add(next);
              next.configureBlocking(false);
              next.connect(UnixDomainSocketAddress.of(file));
            }
          });
      assertTrue(refusal().contains("somebody else has it"), refusal());
      assertThrows(
          SocketTimeoutException.class, () -> ServerConnection.open(file.toString(), 0, 50));
      for (SocketChannel each : waiting) {
        each.close();
      }
    }
  }

  @Test
  void oneOfManyThatStartAtOnceWins() throws Exception {
    for (int round = 0; round < 10; round++) {
      Files.deleteIfExists(file);
      bound(1).close();
      CountDownLatch go = new CountDownLatch(1);
      try (var threads = Executors.newVirtualThreadPerTaskExecutor()) {
        List<Future<UnixSocketFile>> all = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
          all.add(
              threads.submit(() -> {
                go.await();
                try {
                  return UnixSocketFile.listen(file, PRIVATE, 10);
                } catch (IOException e) {
                  return null;
                }
              }));
        }
        go.countDown();
        List<UnixSocketFile> winners = new ArrayList<>();
        for (Future<UnixSocketFile> each : all) {
          if (each.get() != null) {
            winners.add(each.get());
          }
        }
        assertEquals(1, winners.size(), "so many servers have the socket");
        for (UnixSocketFile winner : winners) {
          plain().close();
          winner.close();
          assertFalse(Files.exists(file));
        }
      }
    }
  }

  /** The other one has looked at it, and is about to remove it and to put its own there. */
  @Test
  void whatSomebodyElseIsJustReplacingIsLeftAlone() throws IOException {
    bound(1).close();
    Object stale = Files.getAttribute(file, "unix:ino");
    Path lock = folder.resolve(".console.urbi-lock");
    try (FileChannel other =
        FileChannel.open(lock, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
      assertNotNull(other.tryLock());
      assertTrue(refusal().endsWith("somebody else is just replacing it, and has locked " + lock));
      assertEquals(stale, Files.getAttribute(file, "unix:ino"));
      assertEquals(Set.of(lock, file), Set.copyOf(files()));
    }
    // It has been killed, and its lock has gone with it.
    listen();
    assertServes();
    assertEquals(List.of(file), files());
  }

  @Test
  void theLockIsNoWayToAnotherFile() throws IOException {
    bound(1).close();
    Path precious = Files.writeString(folder.resolve("precious"), "mine");
    Path lock = Files.createSymbolicLink(folder.resolve(".console.urbi-lock"), precious);
    assertTrue(refusal().contains(lock.toString()), refusal());
    assertEquals("mine", Files.readString(precious));
    assertEquals(Set.of(precious, lock, file), Set.copyOf(files()));
  }

  @Test
  void aFileThatIsSomebodyElsesByNowIsNotRemoved() throws IOException {
    ConsoleServer server = listen();
    Files.delete(file);
    listen();
    server.close();
    assertServes();
    Files.delete(file);
    Files.writeString(file, "mine");
    servers.forEach(ConsoleServer::close);
    assertEquals("mine", Files.readString(file));
  }

  @Test
  void pathsThatCannotBeAreNamed() {
    file = folder.resolve("missing/console");
    String refusal = refusal();
    assertTrue(refusal.endsWith("there is no folder " + folder.resolve("missing")), refusal);
    file = folder.resolve("x".repeat(200));
    assertTrue(refusal().endsWith("bytes too many for a socket"), refusal());
  }

  // ------------------------------------------------------------------ clients

  @Test
  void aClientThatEndsItsInputStillGetsItsAnswers() throws IOException {
    listen();
    try (SocketChannel client = plain()) {
      send(client, "for (100) {}; 6*7; lobby.remoteIP;");
      client.shutdownOutput();
      assertEquals(List.of("[] 42", "[] \"\""), lines(client));
    }
  }

  @Test
  void muchGoesThroughWhole() throws IOException {
    listen();
    try (USyncClient client = client()) {
      String text = "\"" + "x".repeat(3_000_000) + "\" + \"y\"";
      assertEquals(3_000_001, client.syncEval(text).stringValue().length());
    }
  }

  @Test
  void theLobbyOfAClientThatVanishesEnds() throws Exception {
    listen();
    try (USyncClient judge = client()) {
      int others = judge.syncEval("lobbies.size").intValue();
      SocketChannel client = plain();
      send(client, "var Global.here = 1|; loop { lobby.send(\"x\" * 100000)|; sleep(1ms) },");
      await(judge, "Global.hasSlot(\"here\")");
      client.close();
      await(judge, "lobbies.size == " + others);
    }
  }

  private static void await(USyncClient judge, String condition) throws InterruptedException {
    long end = System.nanoTime() + TestTimeout.LONG.toNanos();
    while (!judge.syncEval(condition).booleanValue()) {
      assertTrue(System.nanoTime() < end, condition);
      Thread.sleep(20);
    }
  }

  @Test
  void clientsAreLimitedAndTheirProtocolIsLookedAt() throws IOException {
    listen(AccessPolicy.ALL, Limits.DEFAULT.withConnections(1));
    try (SocketChannel first = plain()) {
      try (SocketChannel second = plain()) {
        assertEquals(
            List.of("[:error] !!! this server takes 1 clients at most: closing"), lines(second));
      }
      send(first, "POST / HTTP/1.1\r\n\r\nvar Global.taken = 1;\n");
      assertTrue(lines(first).getFirst().endsWith("does not speak HTTP: closing"));
    }
  }

  @Test
  void tokensAreAskedForHereToo() throws IOException {
    Path tokens = Files.writeString(folder.resolve("tokens"), "user user-0123456789abc me\n");
    Files.setPosixFilePermissions(tokens, PRIVATE);
    listen(new AccessPolicy(Tokens.read(tokens), (Role) null), Limits.DEFAULT);
    try (SocketChannel client = plain()) {
      send(client, "1;\n");
      assertTrue(lines(client).getFirst().contains("asks for a token"));
    }
    try (SocketChannel client = plain()) {
      send(client, "//token user-0123456789abc\n1; shutdown; quit;\n");
      List<String> lines = lines(client);
      assertEquals("[] 1", lines.getFirst());
      assertTrue(lines.get(1).contains("this needs the role owner"), lines.toString());
    }
  }

  @Test
  void remoteProcessesAreServed() throws Exception {
    listen();
    try (RemoteContext remote = new RemoteContext(file.toString(), 0)) {
      assertFalse(remote.onClosed().isDone());
      assertServes();
    }
  }

  @Test
  void toolsTakeTheFileForAHost() throws IOException {
    listen();
    System.setProperty(ServerConnection.TLS_PROPERTY, "1");
    try {
      String host = "--host=" + file;
      ToolResult sent = ToolResult.of(UrbiSend::run, host, "-Q", "-e", "1+2;");
      assertEquals("", sent.err());
      assertTrue(sent.out().endsWith("] 3\n"), sent.out());
      ToolResult interrupted = ToolResult.of(UrbiSend::run, host, "--interrupt");
      assertTrue(interrupted.out().contains("nobody holds the kernel"), interrupted.out());
      ToolResult pinged = ToolResult.of(UrbiPing::run, file.toString(), "1", "1");
      assertEquals(0, pinged.status());
      assertTrue(pinged.out().startsWith("Pinging " + file + "\n1: "), pinged.out());
    } finally {
      System.clearProperty(ServerConnection.TLS_PROPERTY);
    }
  }

  @Test
  void whoFindsNobodyIsToldWhatToDo() throws IOException {
    ToolResult none = ToolResult.of(UrbiSend::run, "-H", file.toString(), "-e", "1;");
    assertEquals(1, none.status());
    assertTrue(
        none.err().contains("No such file or directory (is a server running there? urbi --socket"),
        none.err());
    bound(1).close();
    ToolResult gone = ToolResult.of(UrbiSend::run, "-H", file.toString(), "-e", "1;");
    assertTrue(
        gone.err().contains("cannot connect to " + file + ": Connection refused"), gone.err());
    assertThrows(UClientException.class, this::assertServes);
  }

  // ------------------------------------------------------------------ bad servers

  @Test
  void aSilentServerIsNotWaitedForForEver() throws IOException {
    try (ServerSocketChannel silent = bound(5);
        ServerConnection connection = ServerConnection.open(file.toString(), 0, 1000)) {
      connection.setReadTimeout(20);
      assertThrows(SocketTimeoutException.class, () -> connection.in().read());
      silent.accept().close();
      assertEquals(-1, connection.in().read());
    }
  }

  @Test
  void closingWakesWhoReadsAndWhoWrites() throws Exception {
    try (ServerSocketChannel silent = bound(5)) {
      ServerConnection connection = ServerConnection.open(file.toString(), 0, 1000);
      List<Thread> threads =
          List.of(
              Thread.ofPlatform().start(() -> untilItEnds(() -> connection.in().read())),
              Thread.ofPlatform()
                  .start(() -> untilItEnds(() -> connection.out().write(new byte[1 << 20]))));
      Thread.sleep(50);
      connection.close();
      for (Thread each : threads) {
        assertTrue(each.join(TestTimeout.LONG));
      }
      IOException refusal = assertThrows(IOException.class, () -> connection.in().read());
      assertEquals("Socket closed", refusal.getMessage());
      assertTrue(silent.isOpen());
    }
  }

  private interface Use {
    void of() throws IOException;
  }

  private static void untilItEnds(Use use) {
    try {
      while (true) {
        use.of();
      }
    } catch (IOException e) {
      // This is the end.
    }
  }

  @Test
  void anInterruptOfAThreadDoesNotEndTheConnection() throws Exception {
    try (ServerSocketChannel server = bound(5);
        ServerConnection connection = ServerConnection.open(file.toString(), 0, 1000);
        SocketChannel accepted = server.accept()) {
      byte[] received = new byte[2];
      Thread reader =
          Thread.ofPlatform()
              .start(() -> {
                try {
                  connection.in().readNBytes(received, 0, 2);
                  assertTrue(Thread.currentThread().isInterrupted());
                  connection.out().write(received);
                } catch (IOException e) {
                  throw new UncheckedIOException(e);
                }
              });
      send(accepted, "a");
      reader.interrupt();
      Thread.sleep(20);
      send(accepted, "b");
      assertTrue(reader.join(TestTimeout.LONG));
      assertArrayEquals(new byte[] {'a', 'b'}, received);
      ByteBuffer back = ByteBuffer.allocate(2);
      accepted.read(back);
      assertEquals(2, back.position());
    }
  }

  @Test
  void anEmptyAnswerIsTheEnd() throws IOException {
    try (ServerSocketChannel server = bound(5);
        ServerConnection connection = ServerConnection.open(file.toString(), 0, 1000)) {
      server.accept().close();
      assertNull(new BufferedReader(new InputStreamReader(connection.in())).readLine());
    }
  }
}

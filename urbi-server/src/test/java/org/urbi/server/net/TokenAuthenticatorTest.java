package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Trace;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.Tokens;
import urbi.TokenLine;
import urbi.USyncClient;
import urbi.wire.Protocol;

/** A server that asks for tokens, and those who have one, none, or the wrong one. */
class TokenAuthenticatorTest {
  private static final String OWNER = "owner-0123456789";
  private static final String USER = "user-0123456789a";
  private static final Trace QUIET =
      new Trace(
          Trace.Level.NONE,
          new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8));

  @TempDir Path directory;
  private Kernel kernel;
  private Tokens tokens;
  private ConsoleServer server;

  @BeforeEach
  void start() throws IOException {
    kernel = Kernel.builder().start();
    Path file = directory.resolve("tokens");
    Files.writeString(file, "owner " + OWNER + " boss\nuser " + USER + " guest\n");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
    tokens = Tokens.read(file);
    listen(null);
  }

  private void listen(Role otherwise) throws IOException {
    if (server != null) {
      server.close();
    }
    server =
        new ConsoleServer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            client -> {
              var connection = kernel.connect(client, false);
              connection.send("echo(\"welcome\");\n");
              return connection;
            },
            kernel::connectRemote,
            Limits.DEFAULT,
            new AccessPolicy(tokens, otherwise),
            QUIET);
  }

  @AfterEach
  void stop() {
    System.clearProperty(TokenLine.PROPERTY);
    server.close();
    kernel.close();
  }

  private TestClient client() throws IOException {
    return new TestClient(server.port());
  }

  private static void assertRefused(TestClient client, String text) throws IOException {
    String line = client.line();
    assertTrue(line != null && line.contains(text) && line.endsWith(": closing"), line);
    assertNull(client.line());
  }

  /** What the server has for the lobby that it has opened may come before. */
  private static void assertHeard(TestClient client, String text) throws IOException {
    String line = client.line();
    while (line != null && !line.contains(text)) {
      line = client.line();
    }
    assertTrue(line != null, "not heard: " + text);
  }

  @Test
  void clientWithATokenHasItsRole() throws IOException {
    try (TestClient owner = client();
        TestClient user = client()) {
      owner.send("//token " + OWNER + "\n");
      assertTrue(owner.line().endsWith("*** welcome"));
      assertEquals("[] 1", owner.ask("var Global.shared = 1;"));
      user.send("//tok");
      user.send("en " + USER + "\r\n1 + shared;\n");
      assertTrue(user.line().endsWith("*** welcome"));
      assertTrue(user.line().endsWith(" 2"));
      assertTrue(user.ask("var Global.other = 1;").contains("needs the role owner"));
      assertTrue(user.ask("shutdown;").contains("needs the role owner"));
    }
  }

  @Test
  void clientWithoutATokenIsNotServed() throws IOException {
    for (String said :
        new String[] {
          "var Global.taken = 1;\n", "//\n", "\n", "//token\nvar Global.taken = 1;\n"
        }) {
      try (TestClient nobody = client()) {
        nobody.send(said);
        assertRefused(nobody, "this server asks for a token (--token FILE)");
      }
    }
    try (TestClient nobody = client()) {
      nobody.send("//token " + "x".repeat(10_000));
      assertRefused(nobody, "this token is too long");
    }
    try (TestClient owner = client()) {
      owner.send("//token " + OWNER + "\n");
      owner.line();
      assertEquals("[] false", owner.ask("Global.hasLocalSlot(\"taken\");"));
      assertEquals("[] 2", owner.ask("Lobby.instances.size;"));
    }
  }

  @Test
  void wrongTokensAreDelayedAndTheirInputIsNotExecuted() throws IOException {
    try (TestClient nobody = client()) {
      nobody.send("//token " + OWNER + "x\nvar Global.taken = 1;\n");
      assertRefused(nobody, "wrong token");
    }
    try (TestClient again = client()) {
      again.send("//token " + OWNER + "\n");
      assertRefused(again, "after a wrong token, no other one for");
    }
  }

  @Test
  void clientsWithoutATokenGetTheDefaultRoleAndCanShowOneLater() throws IOException {
    listen(Role.OBSERVER);
    try (TestClient silent = client();
        TestClient owner = client()) {
      assertTrue(silent.line().endsWith("*** welcome"));
      assertTrue(silent.ask("var Global.x = 1;").contains("needs the role owner"));
      assertTrue(owner.line().endsWith("*** welcome"));
      owner.send("//token " + OWNER + "\n");
      assertEquals("[] 1", owner.ask("var Global.x = 1;"));
    }
  }

  @Test
  void processWithObjectsNeedsTheRoleOwner() throws IOException {
    try (TestClient user = client();
        TestClient owner = client()) {
      user.send("//token " + USER + "\n" + Protocol.request());
      assertHeard(user, "needs the role owner");
      owner.send("//token " + OWNER + "\n" + Protocol.request());
      assertHeard(owner, ":" + Protocol.CHANNEL + "] 1 ");
    }
  }

  @Test
  void clientsShowTheTokenOfTheirProcess() {
    System.setProperty(TokenLine.PROPERTY, OWNER);
    USyncClient client = new USyncClient("127.0.0.1", server.port());
    assertEquals(3, client.syncGet("1 + 2;").getValue().intValue());
    client.close();
  }

  @Test
  void serverWithoutTokensIgnoresTokenLines() throws IOException {
    server.close();
    server =
        new ConsoleServer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            client -> kernel.connect(client, false),
            Limits.DEFAULT,
            QUIET);
    try (TestClient owner = client()) {
      owner.send("//token " + OWNER + "\n");
      assertEquals("[] 3", owner.ask("1 + 2;"));
    }
  }
}

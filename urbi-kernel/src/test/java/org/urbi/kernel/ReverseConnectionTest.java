package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.kernel.trust.Role;

/** Clients that are called: {@code Lobby.reverseConnect}. */
class ReverseConnectionTest {
  private Kernel kernel;
  private ServerSocket listener;

  @BeforeEach
  void start() throws IOException {
    kernel = Kernel.builder().log(line -> {}).start();
    listener = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
  }

  @AfterEach
  void end() throws IOException {
    listener.close();
    kernel.close();
  }

  private Socket called() throws IOException {
    kernel.eval("var Global.made = Lobby.reverseConnect(\"127.0.0.1\", " + port() + ")|;");
    return listener.accept();
  }

  private int port() {
    return listener.getLocalPort();
  }

  private static void send(Socket client, String text) throws IOException {
    client.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  private static String line(BufferedReader in) throws IOException {
    String line = in.readLine();
    return line == null ? null : line.replaceFirst("^\\[\\d+", "[");
  }

  private static BufferedReader reader(Socket client) throws IOException {
    return new BufferedReader(
        new InputStreamReader(client.getInputStream(), StandardCharsets.ISO_8859_1));
  }

  @Test
  void aClientThatWasCalledIsAnswered() throws IOException {
    try (Socket client = called()) {
      BufferedReader in = reader(client);
      send(client, "1 + 1;lobby === made;lobby.remoteIP;nobody;");
      assertEquals("[] 2", line(in));
      assertEquals("[] true", line(in));
      assertEquals("[] \"127.0.0.1\"", line(in));
      assertTrue(line(in).startsWith("[:error] !!! "));
      send(client, "\"x\" * 3000000;");
      assertEquals(3_000_000 + "[] \"\"".length(), line(in).length());
    }
    kernel.eval("while (made.connected) sleep(10ms)");
    kernel.eval("while (Lobby.instances.has(made)) sleep(10ms)");
  }

  @Test
  void itMayQuit() throws IOException {
    try (Socket client = called()) {
      send(client, "echo(\"bye\");quit;");
      BufferedReader in = reader(client);
      assertEquals("[] *** bye", line(in));
      assertEquals(null, line(in));
    }
  }

  @Test
  void oneThatDoesNotReadIsLetGo() throws IOException {
    try (Socket client = called()) {
      send(client, "var lump = \"x\" * 1000000|;for (100) lump;every (1ms) echo(lump),");
      kernel.eval("while (made.connected) sleep(10ms)");
    }
  }

  @Test
  void nobodyIsThere() throws IOException {
    int port = port();
    listener.close();
    try {
      kernel.eval("Lobby.reverseConnect(\"127.0.0.1\", " + port + ")");
      throw new AssertionError("there is nobody");
    } catch (UrbiError e) {
      assertTrue(e.getMessage().contains("onnection refused"), e.getMessage());
    }
  }

  @Test
  void usersMayNot() {
    TestClient user = new TestClient(kernel, Role.USER);
    assertTrue(
        user.say("Lobby.reverseConnect(\"127.0.0.1\", " + port() + ");")
            .contains("needs the role owner"));
  }
}

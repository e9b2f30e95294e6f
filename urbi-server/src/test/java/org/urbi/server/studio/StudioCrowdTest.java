package org.urbi.server.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.trust.Role;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.Tokens;

/** Very many who come to the studio's port, and those who send very much. */
class StudioCrowdTest {
  private static final String OWNER = "0123456789abcdef";
  private static final int CROWD = 1000;
  private static final long GIGABYTE = 1 << 30;

  /** What may have been sent before somebody is cut off: what is taken, and what is on its way. */
  private static final long FEW = 64 << 20;

  private static final String REQUEST = " HTTP/1.1\r\nHost: localhost\r\n";

  private static final String UPGRADE =
      "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
          + "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";

  @TempDir static Path folder;
  private static Kernel kernel;
  private static StudioServer studio;

  private final Deque<Socket> crowd = new ArrayDeque<>();

  @BeforeAll
  static void start() throws IOException {
    kernel = Kernel.builder().log(line -> {}).start();
    studio = serve(AccessPolicy.ALL);
  }

  @AfterAll
  static void stop() {
    studio.close();
    kernel.close();
  }

  @AfterEach
  void leave() throws IOException {
    for (Socket each : crowd) {
      each.close();
    }
  }

  private static StudioServer serve(AccessPolicy policy) throws IOException {
    return Served.of(kernel, policy, Shown.VARIABLES, new Folders(folder, null));
  }

  private static AccessPolicy asking(Role withoutToken) {
    return new AccessPolicy(Tokens.single(OWNER, Role.OWNER, "owner"), withoutToken);
  }

  private static Socket connect(StudioServer to) throws IOException {
    return new Socket(InetAddress.getLoopbackAddress(), to.port());
  }

  private static void say(Socket socket, String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  /** One of the crowd comes, and stays. */
  private Socket come(StudioServer to) throws IOException {
    Socket socket = connect(to);
    crowd.add(socket);
    say(socket, "GET /stream" + REQUEST + UPGRADE);
    return socket;
  }

  /** The first message of a stream; "closed" if there is none. */
  private static String firstMessage(Socket socket) throws IOException {
    DataInputStream in = new DataInputStream(new BufferedInputStream(socket.getInputStream()));
    ByteArrayOutputStream head = new ByteArrayOutputStream();
    while (!head.toString(StandardCharsets.ISO_8859_1).endsWith("\r\n\r\n")) {
      int next = in.read();
      if (next < 0) {
        return "closed";
      }
      head.write(next);
    }
    assertEquals(0x81, in.readUnsignedByte(), "a text, in one frame");
    int length = in.readUnsignedByte();
    return new String(
        in.readNBytes(length == 126 ? in.readUnsignedShort() : length), StandardCharsets.UTF_8);
  }

  private static void ownerComesIn(StudioServer to) throws Exception {
    try (StreamClient owner = new StreamClient(to, "/stream?token=" + OWNER)) {
      assertTrue(owner.await("\"hello\"").contains("\"role\":\"owner\""));
    }
  }

  @Test
  void thoseWhoAreNotLetInLockNobodyOut() throws Exception {
    try (StudioServer guarded = serve(asking(null))) {
      for (int i = 1; i <= CROWD; i++) {
        come(guarded);
        if (i % 100 == 0) {
          ownerComesIn(guarded);
        }
      }
    }
  }

  @Test
  void ownersComeInHoweverManyLook() throws Exception {
    try (StudioServer open = serve(asking(Role.OBSERVER))) {
      int seeing = 0;
      int refused = 0;
      for (int i = 1; i <= CROWD; i++) {
        String first = firstMessage(come(open));
        if (first.contains("\"hello\"") && refused == 0) {
          seeing++;
        } else if (!first.contains("\"hello\"")) {
          refused++;
          assertTrue(first.startsWith("{\"type\":\"refused\",\"text\":\"6"), first);
          assertTrue(
              first.endsWith(" look already: there is no place for another one\",\"again\":30}"),
              first);
        }
        if (i % 100 == 0) {
          ownerComesIn(open);
        }
      }
      assertEquals(60, seeing, "before the first one who is refused");
    }
  }

  @Test
  void limitIsToldAndAPlaceIsFreeWhenSomebodyLeaves() throws Exception {
    try (StudioServer full = serve(AccessPolicy.ALL)) {
      for (int i = 0; i < 64; i++) {
        assertTrue(firstMessage(come(full)).contains("\"hello\""));
      }
      String told = "64 look already: there is no place for another one";
      try (StreamClient late = new StreamClient(full, "/stream")) {
        late.await("{\"type\":\"refused\",\"text\":\"" + told + "\",\"again\":30}");
        late.await("closed"::equals);
        assertEquals(1013, late.status);
        assertEquals(told, late.reason);
      }
      crowd.removeFirst().close();
      while (!firstMessage(come(full)).contains("\"hello\"")) {}
    }
  }

  @Test
  void longMessageEndsOnlyItsOwnConnectionAndIsTold() throws Exception {
    try (StreamClient good = new StreamClient(studio, "/stream");
        StreamClient longWinded = new StreamClient(studio, "/stream")) {
      longWinded.await("\"hello\"");
      longWinded.send("x".repeat(Request.LONGEST + 1));
      String told = "a message may have " + Request.LONGEST + " bytes, not more";
      longWinded.await("{\"type\":\"refused\",\"text\":\"" + told + "\",\"again\":0}");
      longWinded.await("closed"::equals);
      assertEquals(1009, longWinded.status);
      good.heard.clear();
      good.await("\"complete\":true");
    }
  }

  /** What is answered before the other end closes. */
  private static String answer(String request) throws IOException {
    try (Socket socket = connect(studio)) {
      say(socket, request);
      return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  @Test
  void largeRequestsAreRefused() throws Exception {
    String large = "Content-Length: " + GIGABYTE + "\r\n";
    for (String head : List.of(large, large + "Expect: 100-continue\r\n")) {
      String told = answer("POST /" + REQUEST + head + "\r\n");
      assertTrue(told.startsWith("HTTP/1.1 413"), told);
    }
  }

  private static boolean goesOn(Socket socket, String text) {
    try {
      say(socket, text);
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  /** How many bytes can be sent until the connection is cut off; others are answered meanwhile. */
  private static long taken(String head, String then) throws IOException {
    String part = "10000\r\n" + "x".repeat(0x10000) + "\r\n";
    try (Socket socket = connect(studio)) {
      say(socket, head);
      if (!then.isEmpty()) {
        assertEquals(
            'H', socket.getInputStream().read(), "an answer, before which nothing is heard");
        say(socket, then);
      }
      int parts = 0;
      while ((long) parts * part.length() < GIGABYTE && goesOn(socket, part)) {
        if (++parts % 16 == 0) {
          pageIsServed();
        }
      }
      return (long) parts * part.length();
    }
  }

  private static void pageIsServed() throws IOException {
    String page = answer("GET /" + REQUEST + "Connection: close\r\n\r\n");
    assertTrue(page.startsWith("HTTP/1.1 200"), page);
  }

  @Test
  void endlessRequestsAndMessagesAreCutOff() throws Exception {
    String large = "POST /" + REQUEST + "Content-Length: " + GIGABYTE + "\r\n";
    for (String head :
        List.of(
            large + "\r\n",
            large + "Expect: 100-continue\r\n\r\n",
            "POST /" + REQUEST + "Transfer-Encoding: chunked\r\n\r\n",
            "GET /" + REQUEST + "X: ")) {
      long bytes = taken(head, "");
      assertTrue(bytes < FEW, () -> bytes + " bytes were taken of " + head);
      pageIsServed();
    }
    // The head of a frame of a gigabyte, with a mask.
    String frame = "\u0082\u00ff\0\0\0\0\u0040\0\0\0\1\2\3\4";
    long bytes = taken("GET /stream" + REQUEST + UPGRADE, frame);
    assertTrue(bytes < FEW, () -> bytes + " bytes were taken of a message");
    pageIsServed();
  }
}

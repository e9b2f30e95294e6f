package org.urbi.sim.page;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.vision.Blob;
import org.urbi.sim.world.Mount;
import org.urbi.sim.world.SimulatedWorld;
import org.urbi.sim.world.WorldReader;
import urbi.UImage;
import urbi.UImageFormat;

class PageServerTest {
  private static final String LOCAL = "127.0.0.1";

  /** How long what must come is waited for: less than the limit of a test, which the pom sets. */
  private static final Duration LIMIT =
      Duration.ofSeconds(Integer.getInteger("test.limit", 600) / 2);

  private static final List<String> FILES =
      List.of(
          "",
          "page.css",
          "page.js",
          "stream.js",
          "shared/stream.js",
          "camera.js",
          "scene.js",
          "plots.js",
          "space.js",
          "parts.js",
          "orbit.js",
          "controls.js",
          "libraries/three.module.js",
          "libraries/three.core.js");
  private static final byte[] JPEG = {(byte) 0xff, (byte) 0xd8, 1, 2, 3, (byte) 0xff, (byte) 0xd9};

  private static final String WORLD =
      """
      world { step 1 ms }
      body floor { plane { colour 1 1 1; checker 0 0 0; tile 50 cm } }
      body arm { at 0 0 1; mass 1; box { size 0.5 0.1 0.1; colour 1 0.5 0 } }
      hinge elbow { of world arm; axis 0 0 1; limits -1 2; drive position; force 5 }
      camera eye { at 0 0 3; size 80 60; xfov 60 deg }
      """;

  private static final String UPGRADE =
      String.join(
          "\r\n",
          "GET /stream HTTP/1.1",
          "Host: localhost",
          "Upgrade: websocket",
          "Connection: Upgrade",
          "Sec-WebSocket-Version: 13",
          "Sec-WebSocket-Key: MDEyMzQ1Njc4OWFiY2RlZg==",
          "\r\n");

  private static final Snapshot.Clock CLOCK = new Snapshot.Clock(false, 1);

  private final BlockingQueue<String> orders = new LinkedBlockingQueue<>();
  private final SimulatedWorld world = WorldReader.read("test.world", WORLD, "ode4j");
  private final HttpClient client = HttpClient.newHttpClient();
  private PageServer server;

  @BeforeEach
  void serve() {
    Mount.Camera eye = world.mount(Mount.Camera.class, "eye");
    server = new PageServer(LOCAL, 0, WorldDescription.of(world, eye), this::take);
  }

  @AfterEach
  void close() {
    client.shutdownNow();
    server.close();
    world.close();
  }

  private Snapshot moment(long imageNumber, byte[] jpeg) {
    UImage image = new UImage(UImageFormat.IMAGE_JPEG, 80, 60, jpeg);
    Blob blob = new Blob(0.25, -0.125, 0.5, 1, 0, 3);
    return Snapshot.of(
        world, CLOCK, new Snapshot.CameraView(Pose.ORIGIN, image, imageNumber, true, blob));
  }

  /** What a browser has been sent: texts, and the bytes of images. */
  private static final class Stream implements WebSocket.Listener {
    final BlockingQueue<Object> received = new LinkedBlockingQueue<>();
    private final StringBuilder text = new StringBuilder();
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    @Override
    public CompletionStage<?> onText(WebSocket socket, CharSequence data, boolean last) {
      text.append(data);
      if (last) {
        received.add(text.toString());
        text.setLength(0);
      }
      socket.request(1);
      return null;
    }

    @Override
    public CompletionStage<?> onBinary(WebSocket socket, ByteBuffer data, boolean last) {
      byte[] part = new byte[data.remaining()];
      data.get(part);
      bytes.writeBytes(part);
      if (last) {
        received.add(bytes.toByteArray());
        bytes.reset();
      }
      socket.request(1);
      return null;
    }

    Object next() throws InterruptedException {
      return PageServerTest.next(received);
    }
  }

  private void take(String viewer, String order) {
    orders.add(order);
    if (order.equals("nonsense")) {
      server.tell(viewer, "what is that?");
    }
  }

  private Stream watch() throws InterruptedException {
    Stream stream = new Stream();
    connect(stream);
    return stream;
  }

  /** What it is told first is that it may intervene. */
  private WebSocket connect(Stream stream) throws InterruptedException {
    WebSocket socket =
        client
            .newWebSocketBuilder()
            .buildAsync(URI.create("ws://127.0.0.1:" + server.port() + "/stream"), stream)
            .join();
    assertEquals("{\"type\":\"may\",\"text\":\"\"}", stream.next());
    return socket;
  }

  /** Waits for what the thread of the page does, and tells nobody of. */
  private static void await(String what, BooleanSupplier done) {
    long deadline = System.nanoTime() + LIMIT.toNanos();
    while (!done.getAsBoolean()) {
      assertTrue(System.nanoTime() < deadline, "in vain: " + what);
      LockSupport.parkNanos(1_000_000);
    }
  }

  private static <T> T next(BlockingQueue<T> queue) throws InterruptedException {
    T next = queue.poll(LIMIT.toSeconds(), TimeUnit.SECONDS);
    assertNotNull(next, "nothing comes");
    return next;
  }

  /** Sends a request as it stands, and returns the first line of the answer. */
  private String ask(String... lines) throws IOException {
    try (Socket socket = new Socket(InetAddress.getByName(LOCAL), server.port())) {
      return ask(socket, lines);
    }
  }

  private static String ask(Socket socket, String... lines) throws IOException {
    String request = String.join("\r\n", lines) + "\r\n\r\n";
    socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
    StringBuilder first = new StringBuilder();
    InputStream in = socket.getInputStream();
    for (int c = in.read(); c != '\r' && c >= 0; c = in.read()) {
      first.append((char) c);
    }
    return first.toString();
  }

  @Test
  void filesOfThePageAreServed() throws Exception {
    for (String file : FILES) {
      HttpRequest request = HttpRequest.newBuilder(URI.create(server.url() + file)).build();
      HttpResponse<String> answer = client.send(request, HttpResponse.BodyHandlers.ofString());
      assertEquals(200, answer.statusCode(), file);
      assertTrue(answer.body().length() > 500, file);
    }
    String host = "Host: localhost:" + server.port();
    assertEquals("HTTP/1.1 404 Not Found", ask("GET /pom.xml HTTP/1.1", host));
    assertEquals("HTTP/1.1 404 Not Found", ask("GET /../page/Json.class HTTP/1.1", host));
    assertEquals("HTTP/1.1 405 Method Not Allowed", ask("POST / HTTP/1.1", host));
    assertEquals("HTTP/1.1 400 Bad Request", ask("nonsense"));
    assertEquals("HTTP/1.1 200 OK", ask("GET / HTTP/1.1", host), "it goes on");
  }

  @Test
  void pagesOfOtherOriginsAreRefused() throws Exception {
    assertEquals("HTTP/1.1 403 Forbidden", ask("GET / HTTP/1.1", "Host: rebound.example"));
    assertEquals("HTTP/1.1 403 Forbidden", ask("GET / HTTP/1.1"));
    String[] upgrade = {
      "GET /stream HTTP/1.1",
      "Host: 127.0.0.1:" + server.port(),
      "Upgrade: websocket",
      "Connection: Upgrade",
      "Sec-WebSocket-Version: 13",
      "Sec-WebSocket-Key: MDEyMzQ1Njc4OWFiY2RlZg==",
      ""
    };
    upgrade[6] = "Origin: http://elsewhere.example";
    assertEquals("HTTP/1.1 403 Forbidden", ask(upgrade));
    assertEquals(0, server.viewers());
    upgrade[6] = "Origin: http://127.0.0.1:" + server.port();
    assertEquals("HTTP/1.1 101 Switching Protocols", ask(upgrade));
  }

  @Test
  void snapshotsAreStreamedToViewers() throws Exception {
    assertFalse(server.isWaiting(), "nobody looks");
    Stream first = watch();
    String setting = (String) first.next();
    assertTrue(setting.contains("\"name\":\"eye\""), setting);
    assertTrue(
        setting.contains(
            "{\"name\":\"elbow\",\"control\":\"position\",\"unit\":\"rad\",\"low\":-1,\"high\":2}"),
        setting);
    assertTrue(setting.contains("\"shape\":\"box\",\"size\":[0.5,0.1,0.1]"), setting);
    await("readiness", server::isWaiting);
    assertEquals(1, server.viewers());
    world.drive("elbow").setTarget(0.5);
    world.step();
    server.show(moment(1, JPEG));
    String shown = (String) first.next();
    assertTrue(shown.startsWith("{\"type\":\"moment\",\"time\":0.001,"), shown);
    assertTrue(shown.contains(",0.5]],\"eyes\":[[0,0,3,"), shown);
    assertTrue(shown.contains("\"paused\":false,\"speed\":1,\"sight\":"), shown);
    assertTrue(shown.contains("\"blob\":[0.25,-0.125,0.5]"), shown);
    assertArrayEquals(JPEG, (byte[]) first.next());
    server.show(moment(1, JPEG));
    first.next();
    assertNull(first.received.poll(200, TimeUnit.MILLISECONDS), "the image is no other one");
    // Who comes later is sent all that there is.
    Stream second = watch();
    assertEquals(setting, second.next());
    assertEquals(shown, second.next());
    assertArrayEquals(JPEG, (byte[]) second.next());
    server.describe("{\"type\":\"setting\"}");
    assertEquals("{\"type\":\"setting\"}", first.next());
  }

  @Test
  void ordersAreTakenAndTheirFailuresToldToOne() throws Exception {
    Stream other = watch();
    Stream stream = new Stream();
    WebSocket socket = connect(stream);
    socket.sendText("step 3", true).join();
    assertEquals("step 3", next(orders));
    socket.sendText("nonsense", true).join();
    stream.next();
    assertEquals("{\"type\":\"refusal\",\"text\":\"what is that?\"}", stream.next());
    other.next();
    server.describe("{}");
    assertEquals("{}", other.next(), "it was told nothing of that");
  }

  @Test
  void robotWhoseDriverHasGoneStops() throws Exception {
    WebSocket idle = connect(new Stream());
    WebSocket driver = connect(new Stream());
    driver.sendText("drive 0.5 1", true).join();
    assertEquals("drive 0.5 1", next(orders));
    idle.abort();
    driver.abort();
    assertEquals("drive 0 0", next(orders));
    WebSocket parked = connect(new Stream());
    parked.sendText("drive 1 0", true).join();
    parked.sendText("drive 0 0", true).join();
    parked.abort();
    assertEquals("drive 1 0", next(orders));
    assertEquals("drive 0 0", next(orders));
    await("all have left", () -> server.viewers() == 0);
    assertNull(orders.poll(), "it had stopped");
  }

  @Test
  void whoGivesTooManyOrdersIsToldAndDisconnected() throws Exception {
    Stream stream = new Stream();
    WebSocket socket = connect(stream);
    stream.next();
    while (stream.received.isEmpty()) {
      socket.sendText("drive 1 0", true).exceptionally(failure -> socket).join();
    }
    String told = (String) stream.next();
    assertTrue(told.contains("Too many orders: at most 60 in a second."), told);
    await("all have left", () -> server.viewers() == 0);
    String last = "";
    for (String order = orders.poll(); order != null; order = orders.poll()) {
      last = order;
    }
    assertEquals("drive 0 0", last, "nobody drives any more");
    assertTrue(((String) watch().next()).contains("setting"), "it may come again");
  }

  /** What comes over a new stream, until the server closes it. */
  private String streamed(String said) throws IOException {
    try (Socket socket = new Socket(InetAddress.getByName(LOCAL), server.port())) {
      socket.getOutputStream().write(UPGRADE.getBytes(StandardCharsets.US_ASCII));
      assertEquals(
          'H', socket.getInputStream().read(), "the answer, before which nothing is heard");
      socket.getOutputStream().write(said.getBytes(StandardCharsets.ISO_8859_1));
      return new String(socket.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
    }
  }

  @Test
  void limitsAreTold() throws Exception {
    // The head of a text of 65,535 bytes.
    String told = streamed("\u0081\u00fe\u00ff\u00ff");
    assertTrue(told.endsWith("\u0003\u00f1a message may have 1024 bytes, not more"), told);
    await("that it has left", () -> server.viewers() == 0);
    for (int i = 0; i < 64; i++) {
      watch();
    }
    told = streamed("");
    String full = "64 look already: there is no place for another one";
    assertTrue(told.endsWith("\u0003\u00f5" + full), told);
    assertEquals(64, server.viewers());
  }

  @Test
  void pagesForOtherMachinesCanOnlyBeLookedAt() throws Exception {
    server.close();
    server = new PageServer("0.0.0.0", 0, WorldDescription.of(world, null), this::take);
    Stream stream = new Stream();
    WebSocket socket =
        client
            .newWebSocketBuilder()
            .buildAsync(URI.create("ws://127.0.0.1:" + server.port() + "/stream"), stream)
            .join();
    assertTrue(((String) stream.next()).contains("\"may\",\"text\":\"This page also serves"));
    stream.next();
    socket.sendText("step 3", true).join();
    assertTrue(((String) stream.next()).contains("\"refusal\",\"text\":\"This page also serves"));
    assertNull(orders.poll());
  }

  @Test
  void whoLooksIsToldThatThePageIsClosed() throws Exception {
    try (Socket viewer = new Socket(InetAddress.getByName(LOCAL), server.port())) {
      viewer.getOutputStream().write(UPGRADE.getBytes(StandardCharsets.US_ASCII));
      await("a viewer", () -> server.viewers() == 1);
      server.close();
      byte[] all = viewer.getInputStream().readAllBytes();
      String end = new String(all, StandardCharsets.ISO_8859_1);
      assertTrue(end.endsWith("\u0088\u0016\u0003\u00e9Endpoint unavailable"), end);
    }
  }

  @Test
  void invalidImagesAreReported() throws Exception {
    Stream stream = watch();
    stream.next();
    UImage wrong = new UImage(UImageFormat.IMAGE_RGB, 80, 60, new byte[5]);
    server.show(
        Snapshot.of(world, CLOCK, new Snapshot.CameraView(Pose.ORIGIN, wrong, 1, false, null)));
    List<String> texts = List.of((String) stream.next(), (String) stream.next());
    assertTrue(texts.stream().anyMatch(text -> text.contains("no image: ")), texts.toString());
    server.show(moment(2, JPEG));
    stream.next();
    assertArrayEquals(JPEG, (byte[]) stream.next());
  }

  @Test
  void slowViewerGetsFewerSnapshotsAndDelaysNothing() throws Exception {
    byte[] large = new byte[1_000_000];
    int moments = 40;
    try (Socket asleep = new Socket()) {
      asleep.setReceiveBufferSize(1 << 16);
      asleep.connect(new InetSocketAddress(LOCAL, server.port()));
      asleep.getOutputStream().write(UPGRADE.getBytes(StandardCharsets.US_ASCII));
      Stream awake = watch();
      awake.next();
      await("two viewers", () -> server.viewers() == 2);
      for (int number = 1; number <= moments; number++) {
        server.show(moment(number, large));
        awake.next();
        assertEquals(large.length, ((byte[]) awake.next()).length);
      }
      server.describe("{}");
      // What the one who sleeps was owed is in buffers of the system, and a little in the server's.
      long owed = bytesUntil(asleep, "\u0081\u0002{}");
      assertTrue(owed < moments / 2 * large.length, owed + " bytes");
    }
  }

  /** How many bytes come until the last of them are as given. */
  private static long bytesUntil(Socket socket, String end) throws IOException {
    socket.setSoTimeout((int) LIMIT.toMillis());
    byte[] part = new byte[1 << 16];
    long all = 0;
    String last = "";
    while (!last.endsWith(end)) {
      int count = socket.getInputStream().read(part);
      assertTrue(count > 0, "closed after " + all + " bytes");
      all += count;
      last = last + new String(part, 0, count, StandardCharsets.ISO_8859_1);
      last = last.substring(Math.max(0, last.length() - end.length()));
    }
    return all;
  }

  @Test
  void whoAsksForNothingGivesWayToOthers() throws Exception {
    List<Socket> crowd = new ArrayList<>();
    try {
      for (int i = 0; i < 80; i++) {
        crowd.add(new Socket(InetAddress.getByName(LOCAL), server.port()));
      }
      crowd.getFirst().setSoTimeout((int) LIMIT.toMillis());
      assertEquals(-1, crowd.getFirst().getInputStream().read(), "closed");
      assertEquals(
          "HTTP/1.1 200 OK", ask(crowd.getLast(), "GET / HTTP/1.1", "Host: localhost"), "not all");
    } finally {
      for (Socket each : crowd) {
        each.close();
      }
    }
  }

  @Test
  void unusablePortsAreReported() throws Exception {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getByName(LOCAL))) {
      String message =
          assertThrows(
                  SimulationException.class,
                  () -> new PageServer(LOCAL, taken.getLocalPort(), "{}", this::take))
              .getMessage();
      assertTrue(
          message.startsWith("page: cannot use port " + taken.getLocalPort() + " of 127.0.0.1"),
          message);
    }
    assertEquals(
        "page: port: between 0 and 65535 expected, not 70000",
        assertThrows(
                SimulationException.class, () -> new PageServer(LOCAL, 70_000, "{}", this::take))
            .getMessage());
    assertEquals(
        "page: unknown host: no.such.host.invalid",
        assertThrows(
                SimulationException.class,
                () -> new PageServer("no.such.host.invalid", 0, "{}", this::take))
            .getMessage());
  }

  @Test
  void nothingIsLeftBehind() throws Exception {
    int port = server.port();
    server.close();
    assertFalse(isOpen(port));
    await("the end of its thread", () -> pageThreads() == 0);
    server.show(moment(1, JPEG));
    assertEquals(0, server.viewers(), "nobody looks, and nobody is hurt");
  }

  @Test
  void thePortCanBeUsedAgainAtOnce() {
    int port = server.port();
    for (int i = 0; i < 50; i++) {
      server.close();
      server = new PageServer(LOCAL, port, "{}", this::take);
    }
    assertEquals(port, server.port());
  }

  private static boolean isOpen(int port) throws IOException {
    try (Socket socket = new Socket(InetAddress.getByName(LOCAL), port)) {
      return true;
    } catch (ConnectException e) {
      return false;
    }
  }

  private static long pageThreads() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().startsWith("page-"))
        .count();
  }
}

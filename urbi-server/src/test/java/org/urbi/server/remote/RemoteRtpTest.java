package org.urbi.server.remote;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.server.TestTimeout;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;
import urbi.UClass;
import urbi.UImage;
import urbi.UImageFormat;
import urbi.UModule;
import urbi.UObject;
import urbi.USyncClient;
import urbi.UVar;
import urbi.remote.RemoteContext;
import urbi.rtp.RtpOptions;

/** Values in datagrams, by real sockets, through a relay that loses what it is told to. */
class RemoteRtpTest {
  private static final String HOST = "127.0.0.1";
  private static final int IMAGE = 640 * 480 * 3;
  private static final int SMALL = 3 * 1000;
  private static final int EVEN = 3500;

  private Kernel kernel;
  private ConsoleServer server;
  private RemoteContext remote;
  private USyncClient client;
  private UdpRelay relay;

  @BeforeEach
  void start() throws IOException {
    Camera.SEEN.clear();
    kernel = Kernel.builder().start();
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    server =
        new ConsoleServer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            each -> kernel.connect(each, false),
            kernel::connectRemote,
            Limits.DEFAULT,
            new Trace(Trace.Level.NONE, nowhere));
    relay = new UdpRelay(server.port());
    remote = new RemoteContext(HOST, server.port());
    client = USyncClient.connect(HOST, server.port(), TestTimeout.LONG);
    client.setDefaultTimeout(TestTimeout.LONG);
    client.syncEval("var Global.image = 0");
    remote.start(new UClass("Camera", new UModule("test"), Camera::new));
  }

  @AfterEach
  void stop() {
    client.close();
    remote.close();
    relay.close();
    kernel.close();
    server.close();
  }

  static class Camera extends UObject {
    static final BlockingQueue<UImage> SEEN = new LinkedBlockingQueue<>();
    final UVar val = new UVar();
    final UVar number = new UVar();

    Camera(String name) {
      super(name);
      UBindVar(val, "val");
      UBindVar(number, "number");
      val.setValue(0);
      UNotifyChange("Global.image", "onImage");
      UBindFunctions("shoot", "count", "useRtp");
    }

    public void onImage(UImage image) {
      SEEN.add(image);
    }

    public void shoot(int seed, int size) {
      val.setValue(new UImage(UImageFormat.IMAGE_RGB, 640, 480, data(seed, size)));
    }

    public void count(double value) {
      number.setValue(value);
    }

    public void useRtp(boolean on) {
      number.useRTP(on);
    }
  }

  private static byte[] data(int seed, int size) {
    byte[] data = new byte[size];
    new Random(seed).nextBytes(data);
    data[0] = (byte) seed;
    return data;
  }

  private String eval(String expression) {
    return client.syncEval(expression).toString();
  }

  private void use(int datagram) throws Exception {
    eval("loadModule(\"urbi/rtp\")");
    RtpOptions options = new RtpOptions(datagram, relay.port(), TestTimeout.LONG);
    assertTrue(remote.useRtp(options).get());
  }

  private void awaitImage(int seed) {
    byte[] expected = data(seed, 1);
    eval(
        "while (!Camera.val.isA(Binary) || Camera.val.data[0] != \"\\x%02x\") sleep(1ms)"
            .formatted(expected[0]));
  }

  private static UImage seen() throws InterruptedException {
    return Camera.SEEN.take();
  }

  /** The sequence numbers of datagrams, from the first on. */
  private static int[] sequence(List<byte[]> datagrams) {
    int[] numbers =
        datagrams.stream().mapToInt(each -> ByteBuffer.wrap(each).getShort(2) & 0xffff).toArray();
    int first = numbers[0];
    return Arrays.stream(numbers).map(each -> each - first & 0xffff).toArray();
  }

  @Test
  void lastOfSeveralRtpOffersCounts() throws Exception {
    eval("loadModule(\"urbi/rtp\")");
    RtpOptions options = new RtpOptions(0, relay.port(), TestTimeout.LONG);
    for (int i = 0; i < 20; i++) {
      remote.useRtp(options);
    }
    assertTrue(remote.useRtp(options).get());
    eval("Camera.shoot(1, 3000)");
    awaitImage(1);
    assertEquals(1, relay.toServer().size());
  }

  @Test
  void largeImagesBothWays() throws Exception {
    use(0);
    for (int seed = 1; seed <= 20; seed++) {
      eval("Camera.shoot(" + seed + ", " + IMAGE + ")");
      awaitImage(seed);
      eval("{ Global.image = Camera.val | 0 }");
      assertArrayEquals(data(seed, IMAGE), seen().getData());
    }
    assertEquals(20, remote.rtpCounts().sent());
    assertEquals(20, remote.rtpCounts().received());
    List<byte[]> datagrams = relay.toServer();
    assertEquals(20 * 29, datagrams.size());
    int[] numbers = sequence(datagrams);
    for (int i = 0; i < numbers.length; i++) {
      assertEquals(i & 0xffff, numbers[i]);
      assertEquals(i % 29 == 28, datagrams.get(i)[1] < 0, "the marker");
    }
  }

  @Test
  void fragmentsBelowTheMtu() throws Exception {
    use(1440);
    eval("Camera.shoot(3, " + IMAGE + ")");
    awaitImage(3);
    assertEquals(653, relay.toServer().size());
    assertTrue(relay.toServer().stream().allMatch(each -> each.length <= 1440));
  }

  @Test
  void lostImagesAreNotShown() throws Exception {
    use(500);
    AtomicInteger count = new AtomicInteger();
    // Of each image, seven datagrams: the second one loses its third.
    relay.setFate(each -> count.incrementAndGet() == 10 ? List.of() : List.of(each));
    eval("Camera.shoot(1, " + SMALL + ")");
    awaitImage(1);
    eval("Camera.shoot(2, " + SMALL + ")");
    eval("sleep(100ms)");
    assertEquals("1", eval("if (Camera.val.data[0] == \"\\x01\") 1 else 0"));
    eval("Camera.shoot(3, " + SMALL + ")");
    awaitImage(3);
    assertEquals(21, count.get());
  }

  @Test
  void lossInTheOtherDirectionIsCounted() throws Exception {
    use(500);
    eval("Camera.shoot(1, " + SMALL + ")");
    awaitImage(1);
    AtomicInteger count = new AtomicInteger();
    relay.setFate(each -> count.incrementAndGet() == 2 ? List.of() : List.of(each));
    eval("{ Global.image = Camera.val | 0 }");
    eval("{ Global.image = Camera.val | 0 }");
    assertArrayEquals(data(1, SMALL), seen().getData());
    assertNull(Camera.SEEN.poll(50, TimeUnit.MILLISECONDS));
    assertEquals(1, remote.rtpCounts().incomplete());
    assertEquals(1, remote.rtpCounts().received());
  }

  @Test
  void disorderAndDuplicatesAreHealed() throws Exception {
    use(500);
    ArrayDeque<byte[]> held = new ArrayDeque<>();
    // Pairs change places, and each comes twice.
    relay.setFate(each -> {
      held.addFirst(each);
      if (held.size() < 2) {
        return List.of();
      }
      return List.of(held.peek(), held.poll(), held.peek(), held.poll());
    });
    eval("Camera.shoot(1, " + EVEN + ")");
    eval("Camera.shoot(2, " + EVEN + ")");
    awaitImage(2);
    for (int i = 0; i < 2; i++) {
      eval("{ Global.image = Camera.val | 0 }");
      assertArrayEquals(data(2, EVEN), seen().getData());
    }
    assertEquals(2, remote.rtpCounts().received());
    assertTrue(remote.rtpCounts().duplicates() + remote.rtpCounts().late() >= 12);
    assertEquals(0, remote.rtpCounts().incomplete());
  }

  @Test
  void oldImageDoesNotReplaceANewerOne() throws Exception {
    use(500);
    List<byte[]> first = new ArrayList<>();
    relay.setFate(each -> {
      if (first.size() < 7) {
        first.add(each);
        return List.of();
      }
      return List.of(each);
    });
    eval("Camera.shoot(1, " + SMALL + ")");
    eval("Camera.shoot(2, " + SMALL + ")");
    awaitImage(2);
    for (byte[] each : first) {
      relay.send(each, new InetSocketAddress(HOST, server.port()));
    }
    eval("sleep(100ms)");
    assertEquals("1", eval("if (Camera.val.data[0] == \"\\x02\") 1 else 0"));
  }

  @Test
  void datagramsWithoutTheTokenAreDropped() throws Exception {
    use(500);
    eval("Camera.shoot(1, " + SMALL + ")");
    awaitImage(1);
    try (DatagramSocket stranger = new DatagramSocket()) {
      Random random = new Random(3);
      for (int i = 0; i < 200; i++) {
        byte[] garbage = new byte[random.nextInt(100)];
        random.nextBytes(garbage);
        send(stranger, garbage);
      }
      for (byte[] each : relay.toServer()) {
        byte[] forged = each.clone();
        // The newest of all, with another token.
        forged[2] ^= 0x20;
        forged[15] ^= 1;
        send(stranger, forged);
      }
    }
    eval("Camera.shoot(2, " + SMALL + ")");
    awaitImage(2);
    assertEquals(14, relay.toServer().size());
  }

  @Test
  void invalidDatagramsWithTheRightTokenAreDropped() throws Exception {
    use(500);
    Random random = new Random(11);
    AtomicBoolean breaking = new AtomicBoolean(true);
    // Beyond the token all may be wrong: the variable, the parts, and what they are of.
    relay.setFate(each -> {
      if (breaking.get()) {
        for (int i = 0; i < 3; i++) {
          each[20 + random.nextInt(Math.min(60, each.length - 20))] = (byte) random.nextInt();
        }
      }
      return List.of(each);
    });
    eval("Camera.&number.rtp = true");
    eval("for| (var i = 0; i < 300; i += 1) { Camera.shoot(1, 40) | Camera.count(i) }");
    eval(
        "for| (var i = 0; i < 300; i += 1) {"
            + " Global.image = Binary.new(\"rgb 2 2\", \"123456789012\") | sleep(1ms) }");
    breaking.set(false);
    client.send("Global.image = 0;");
    while (Camera.SEEN.poll(200, TimeUnit.MILLISECONDS) != null) {
      // What has been broken, and is an image all the same.
    }
    for (int i = 1; i <= 5; i++) {
      eval("Camera.shoot(" + i + ", " + SMALL + ")");
      awaitImage(i);
    }
    eval("{ Global.image = Camera.val | 0 }");
    assertArrayEquals(data(5, SMALL), seen().getData());
    assertEquals("3", eval("1 + 2"));
  }

  @Test
  void largeValuesGoOverTheConnection() throws Exception {
    use(256);
    int large = 5_000_000;
    eval("Camera.shoot(1, 1000)");
    awaitImage(1);
    int before = relay.toServer().size();
    eval("Camera.shoot(2, " + large + ")");
    awaitImage(2);
    assertEquals(before, relay.toServer().size());
    eval("{ Global.image = Camera.val | 0 }");
    assertArrayEquals(data(2, large), seen().getData());
    eval("Camera.shoot(3, 1000)");
    awaitImage(3);
    assertTrue(relay.toServer().size() > before);
  }

  private void send(DatagramSocket from, byte[] bytes) throws IOException {
    from.send(new DatagramPacket(bytes, bytes.length, new InetSocketAddress(HOST, server.port())));
  }

  @Test
  void valuesGoOverTheConnectionWhenUdpIsBlocked() throws Exception {
    eval("loadModule(\"urbi/rtp\")");
    try (DatagramSocket hole = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
      RtpOptions options = new RtpOptions(0, hole.getLocalPort(), Duration.ofMillis(200));
      assertFalse(remote.useRtp(options).get());
    }
    eval("Camera.shoot(4, " + IMAGE + ")");
    awaitImage(4);
    assertEquals(0, relay.toServer().size());
  }

  @Test
  void valuesGoOverTheConnectionWhenDatagramsStop() throws Exception {
    use(1440);
    eval("Camera.shoot(1, " + IMAGE + ")");
    awaitImage(1);
    relay.close();
    eval("Camera.shoot(2, " + IMAGE + ")");
    eval(
        "{ var i = 10; while (Camera.val.data[0] == \"\\x01\")"
            + " { i += 1; Camera.shoot(i, 3000); sleep(20ms) } }");
  }

  @Test
  void theKernelMayLoadTheModuleLater() throws Exception {
    RtpOptions options = new RtpOptions(0, relay.port(), Duration.ofSeconds(5));
    assertFalse(remote.useRtp(options).get());
    eval("loadModule(\"urbi/rtp\")");
    eval("loadModule(\"urbi/rtp\")");
    for (int i = 1; relay.toServer().isEmpty(); i++) {
      eval("Camera.shoot(" + i % 100 + ", 3000)");
    }
    eval("unloadModule(\"urbi/rtp\")");
    eval("Camera.shoot(101, 3000)");
    awaitImage(101);
    while (remote.rtpCounts() != null) {
      Thread.sleep(1);
    }
    int before = relay.toServer().size();
    eval("Camera.shoot(102, 3000)");
    awaitImage(102);
    assertEquals(before, relay.toServer().size());
  }

  @Test
  void rtpIsDecidedPerVariable() throws Exception {
    use(0);
    assertEquals("\"nil\"", eval("Camera.&number.rtp.asString"));
    eval("Camera.count(1)");
    assertEquals("1", eval("Camera.number"));
    assertEquals(0, relay.toServer().size());
    eval("Camera.&number.rtp = true");
    eval("Camera.count(2)");
    eval("while (Camera.number != 2) sleep(1ms)");
    assertEquals(1, relay.toServer().size());
    eval("Camera.useRtp(false)");
    eval("while (Camera.&number.rtp) sleep(1ms)");
    eval("Camera.count(3)");
    assertEquals("3", eval("Camera.number"));
    assertEquals(1, relay.toServer().size());
    eval("UVar.rtp = false");
    eval("Camera.shoot(5, 3000)");
    awaitImage(5);
    assertEquals(1, relay.toServer().size());
    eval("UVar.rtp = nil");
    eval("Camera.shoot(6, 3000)");
    awaitImage(6);
    assertEquals(2, relay.toServer().size());
  }

  @Test
  void manyUpdatesArriveInTheirOrder() throws Exception {
    use(0);
    eval("Camera.&number.rtp = true");
    eval("var Global.last = 0 | var Global.wrong = 0 | 0");
    client.send(
        "at (Camera.&number.changed?(var v)) { if (v <= Global.last) Global.wrong = v |"
            + " Global.last = v };");
    eval("for| (var i = 1; i <= 2000; i += 1) Camera.count(i)");
    eval("while (Camera.number != 2000) sleep(1ms)");
    assertEquals("0", eval("Global.wrong"));
  }
}

package org.urbi.server.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;
import org.urbi.server.TestTimeout;
import org.urbi.server.Trace;
import urbi.UBinary;
import urbi.UCallbackAction;
import urbi.UCallbackInterface;
import urbi.UClient;
import urbi.UClientException;
import urbi.UImage;
import urbi.UImageFormat;
import urbi.UList;
import urbi.UMessage;
import urbi.UMessageType;
import urbi.USyncClient;
import urbi.UValue;

/** The clients of the SDK and a server. */
class ClientTest {
  private static final String HOST = "127.0.0.1";

  private Kernel kernel;
  private ConsoleServer server;
  private final BlockingQueue<UMessage> messages = new LinkedBlockingQueue<>();

  @BeforeEach
  void start() throws IOException {
    kernel = Kernel.builder().start();
    PrintStream nowhere =
        new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    server =
        new ConsoleServer(
            new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
            client -> kernel.connect(client, false),
            Limits.DEFAULT,
            new Trace(Trace.Level.NONE, nowhere));
  }

  @AfterEach
  void stop() {
    kernel.close();
    server.close();
  }

  private USyncClient syncClient() {
    USyncClient client = USyncClient.connect(HOST, server.port(), TestTimeout.LONG);
    client.setDefaultTimeout(TestTimeout.LONG);
    return client;
  }

  private UMessage next() throws InterruptedException {
    UMessage message = messages.take();
    assertNotEquals(null, message);
    return message;
  }

  private UCallbackAction keep(UMessage message) {
    messages.add(message);
    return UCallbackAction.URBI_CONTINUE;
  }

  @Test
  void callbacksAreCalledByTag() throws InterruptedException {
    UClient client = new UClient(HOST, server.port());
    assertEquals(0, client.error());
    class Once extends UCallbackInterface {
      @Override
      public UCallbackAction onMessage(UMessage message) {
        keep(message);
        return UCallbackAction.URBI_REMOVE;
      }
    }
    int once = client.setCallback(new Once(), "tag");
    assertEquals("tag", client.getAssociatedTag(once));
    int all = client.setCallback(this::keep, "tag");
    client.send("var tag = Channel.new(\"tag\") | tag << [1, \"é\"]; tag << %d;", 7);
    for (int i = 0; i < 2; i++) {
      UMessage message = next();
      assertEquals("tag", message.getTag());
      assertEquals(UMessageType.MESSAGE_DATA, message.getType());
      assertEquals(new UValue(UList.of(1, "é")), message.getValue());
      assertEquals(client, message.getClient());
    }
    assertEquals(7, next().getValue().intValue());
    assertEquals(1, client.deleteCallback(all));
    assertEquals(0, client.deleteCallback(all));
    client.setErrorCallback(this::keep);
    client.send("tag << 8; foo;");
    UMessage error = next();
    assertEquals("1.69-71: lookup failed: foo (possible misspelling of log)", error.getMessage());
    assertEquals(UMessageType.MESSAGE_ERROR, error.getType());
    assertTrue(error.toString().matches("\\[\\d{8}:error] !!! 1.*foo .*"), error.toString());
    client.setWildcardCallback(this::keep);
    client.send("echo(\"héllo\");");
    UMessage echo = next();
    assertEquals("héllo", echo.getMessage());
    assertEquals(UMessageType.MESSAGE_SYSTEM, echo.getType());
    client.close();
  }

  @Test
  void questionsAreAnswered() {
    try (USyncClient client = syncClient()) {
      assertEquals(3, client.syncEval("1 + 2").intValue());
      assertEquals("a\"b\\é\n", client.syncEval("\"a\\\"b\\\\é\\n\"").stringValue());
      assertEquals(new UValue(), client.syncEval("void"));
      assertEquals(42, client.syncGet("%s * 2;", 21).getValue().intValue());
      assertEquals(
          "9.20-22: lookup failed: foo (possible misspelling of log)",
          assertThrows(UClientException.class, () -> client.syncEval("foo")).getMessage());
      assertTrue(
          assertThrows(UClientException.class, () -> client.syncEval("1 +"))
              .getMessage()
              .contains("syntax error"));
      assertEquals(
          "no answer within 50 ms to: sleep(1s)",
          assertThrows(
                  UClientException.class, () -> client.syncEval("sleep(1s)", Duration.ofMillis(50)))
              .getMessage());
      assertEquals(5, client.syncEval("5").intValue());
      client.send("class Global.servo { var val = 1.5; var valn = 0.25; };");
      assertEquals(1.5, client.syncGetDevice("servo"));
      assertEquals(0.25, client.syncGetNormalizedDevice("servo"));
      assertTrue(client.ping(TestTimeout.LONG).toNanos() > 0);
    }
  }

  @Test
  void callbacksMayAsk() throws InterruptedException {
    try (USyncClient client = syncClient()) {
      BlockingQueue<Integer> answers = new ArrayBlockingQueue<>(1);
      client.setCallback(
          message -> {
            answers.add(client.syncEval(message.getValue() + " * 2").intValue());
            return UCallbackAction.URBI_CONTINUE;
          },
          "ask");
      client.send("Channel.new(\"ask\") << 21;");
      assertEquals(42, answers.take());
      UClient plain = UClient.connect(HOST, server.port(), TestTimeout.LONG);
      plain.setCallback(
          message -> {
            try {
              plain.waitForKernelVersion();
            } catch (UClientException e) {
              messages.add(message);
            }
            return UCallbackAction.URBI_CONTINUE;
          },
          "ask");
      plain.send("Channel.new(\"ask\") << 21;");
      next();
      plain.close();
    }
  }

  @Test
  void eventsAreProcessedOnDemand() throws InterruptedException {
    try (USyncClient client = syncClient()) {
      client.stopCallbackThread();
      client.setCallback(this::keep, "");
      client.send("1;");
      client.syncEval("2");
      assertTrue(messages.isEmpty());
      assertTrue(client.processEvents());
      assertEquals(1, next().getValue().intValue());
      assertFalse(client.processEvents(1000));
    }
  }

  @Test
  void binariesBothWays() {
    byte[] data = new byte[640 * 480 * 3];
    new Random(3).nextBytes(data);
    try (USyncClient client = syncClient()) {
      client.send("var Global.camera = Object.new | var camera.val = 0|;");
      client.send("camera.val = ");
      client.sendBinary(data, "rgb 640 480");
      client.send(";");
      UImage image = client.syncGetImage("camera", UImageFormat.IMAGE_RGB, TestTimeout.LONG);
      assertEquals(640, image.getWidth());
      assertArrayEquals(data, image.getData());
      UBinary odd = new UBinary("what, ever: (this)", data);
      client.send("camera.val = ");
      client.send(new UValue(odd));
      client.send(";");
      assertEquals(odd, client.syncEval("camera.val").ubinaryValue());
      client.sendBin(new byte[] {'7', ';'}, "camera.val = %d", 1);
      assertEquals(17, client.syncEval("camera.val").intValue());
    }
  }

  @Test
  void soundsAreRecordedForTheGivenTime() {
    try (USyncClient client = syncClient()) {
      client.send(
          "var Global.micro = Object.new | var micro.val = 0 |"
              + " every (10ms) micro.val = Binary.new(\"raw 1 8000 8 2\", \"ab\"),");
      var sound = client.syncGetSound("micro", 200, TestTimeout.LONG);
      assertEquals(8000, sound.getRate());
      assertTrue(sound.getSize() >= 4 && sound.getSize() % 2 == 0, sound.toString());
    }
  }

  @Test
  void versions() {
    try (UClient client = UClient.connect(HOST, server.port(), TestTimeout.LONG)) {
      assertTrue(client.kernelVersion().matches("\\d+\\.\\d+.*"), client.kernelVersion());
      assertTrue(client.kernelMajor() >= 2);
      assertTrue(client.connectionID().startsWith("0x"), client.connectionID());
      assertEquals(2, List.of(client.makeUniqueTag(), client.fresh()).stream().distinct().count());
    }
  }

  @Test
  void nobodyThere() throws IOException {
    int port = server.port();
    server.close();
    UClient client = new UClient(HOST, port);
    assertNotEquals(0, client.error());
    assertEquals(1, client.send("1;"));
    assertTrue(client.errorMessage().startsWith("cannot connect to 127.0.0.1:" + port + ": "));
    assertThrows(UClientException.class, () -> UClient.connect(HOST, port, TestTimeout.LONG));
    USyncClient asking = new USyncClient(HOST, port);
    assertThrows(UClientException.class, () -> asking.syncEval("1"));
  }

  @Test
  void endOfTheServerIsNoticed() throws Exception {
    USyncClient client = syncClient();
    client.setClientErrorCallback(this::keep);
    Thread killer =
        Thread.ofVirtual()
            .start(() -> {
              try {
                Thread.sleep(100);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
              kernel.close();
              server.close();
            });
    UClientException lost =
        assertThrows(UClientException.class, () -> client.syncEval("sleep(inf)"));
    assertEquals(
        "the server has closed the connection before the answer to: sleep(inf)", lost.getMessage());
    assertEquals("the server has closed the connection", next().getMessage());
    client.onClosed().get();
    assertEquals(1, client.error());
    assertThrows(UClientException.class, () -> client.syncEval("1"));
    killer.join();
  }

  @Test
  void silentServerIsNoticed() throws Exception {
    try (ServerSocket silent = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      UClient client = UClient.connect(HOST, silent.getLocalPort(), TestTimeout.LONG);
      client.setClientErrorCallback(this::keep);
      client.setKeepAliveCheck(20, 50);
      assertEquals("the server does not answer within 50 ms", next().getMessage());
      client.onClosed().get();
    }
    try (UClient client = UClient.connect(HOST, server.port(), TestTimeout.LONG)) {
      client.setKeepAliveCheck(10, 10_000);
      Thread.sleep(100);
      assertEquals(0, client.error());
    }
  }

  @Test
  void otherProgramOnThePortIsNoticed() throws Exception {
    try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      UClient client = UClient.connect(HOST, other.getLocalPort(), TestTimeout.LONG);
      client.setClientErrorCallback(this::keep);
      try (Socket peer = other.accept()) {
        peer.getOutputStream()
            .write("HTTP/1.1 400 BIN 99999999999\n".getBytes(StandardCharsets.US_ASCII));
        assertTrue(next().getMessage().startsWith("this is no Urbi server: "));
      }
    }
  }
}

package org.urbi.ros.one;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.logging.Logger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.ros.Awaited;
import org.urbi.ros.FreePorts;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.FullText;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.TypeHash;
import urbi.UDictionary;

/** Peers that say what nobody says, or stop in the middle of it. There is no master here. */
class HostilePeersTest {
  private OneNode node;
  private MessageType text;
  private final InetAddress here = InetAddress.getLoopbackAddress();

  @BeforeEach
  void start() throws IOException {
    node = OneNodeTest.node(FreePorts.next(), "tested");
    text = node.definitions().message("std_msgs/String");
  }

  @AfterEach
  void end() {
    node.close();
  }

  private Map<String, String> header() {
    Map<String, String> header = new LinkedHashMap<>();
    header.put("callerid", "/raw");
    header.put("topic", "/said");
    header.put("type", "std_msgs/String");
    header.put("md5sum", TypeHash.md5(text));
    header.put("message_definition", FullText.write(text));
    return header;
  }

  @Test
  void connectionsWithAnythingInThem() throws Exception {
    Publisher publisher = node.advertise("/said", text, Qos.LATCHED, new Publisher.Listener() {});
    publisher.publish(new UDictionary().with("data", "x"));
    byte[] right = ConnectionHeader.write(header());
    Random dice = new Random(5);
    for (int port : new int[] {node.port(), URI.create(node.uri()).getPort()}) {
      for (int i = 0; i < 200; i++) {
        byte[] broken = Arrays.copyOf(right, dice.nextInt(right.length + 1));
        for (int k = dice.nextInt(5); k > 0 && broken.length > 0; k--) {
          broken[dice.nextInt(Math.min(60, broken.length))] = (byte) dice.nextInt();
        }
        try (Socket socket = new Socket(here, port)) {
          socket.getOutputStream().write(broken);
        } catch (IOException e) {
          // Thrown out in the middle of it: as it should be.
          continue;
        }
      }
    }
    try (TcpRosConnection well = TcpRosConnection.to(here.getHostAddress(), node.port())) {
      well.sendHeader(header());
      assertEquals("std_msgs/String", well.readHeader().get("type"));
      assertEquals(5, well.read().remaining());
    }
    assertEquals(
        "/tested".replace("/", "/space/"),
        node.api(URI.create(node.uri())).call(value -> value, "getName").get());
  }

  /**
   * Publishers that stop in the middle of a message, or send what is none; then one that is well.
   */
  @Test
  void halfMessages() throws Exception {
    byte[][] wrong = {
      {},
      {9},
      {9, 0, 0, 0},
      {9, 0, 0, 0, 5, 0, 0, 0, 'h'},
      {-1, -1, -1, -1},
      {-1, -1, -1, 15, 1, 2, 3},
      {4, 0, 0, 0, -1, -1, -1, -1},
      {9, 0, 0, 0, 1, 0, 0, 0, 'h', 'e', 'l', 'l', 'o'},
    };
    try (ServerSocket data = new ServerSocket(0, 50, here);
        XmlRpcServer slave =
            new XmlRpcServer(
                here,
                (method, arguments) ->
                    List.of(
                        1, "", List.of("TCPROS", here.getHostAddress(), data.getLocalPort())))) {
      Heard heard = new Heard();
      Subscription subscription = node.subscribe("/said", null, Qos.DEFAULT, heard);
      node.updatePublishers("/said", List.of(URI.create("http://127.0.0.1:" + slave.port() + "/")));
      for (byte[] each : wrong) {
        try (Socket socket = data.accept();
            TcpRosConnection connection = new TcpRosConnection(socket)) {
          connection.readHeader();
          connection.sendHeader(header());
          socket.getOutputStream().write(each);
        }
      }
      try (TcpRosConnection connection = new TcpRosConnection(data.accept())) {
        connection.readHeader();
        connection.sendHeader(header());
        connection.write(new byte[] {2, 0, 0, 0, 'o', 'k'});
        connection.flush();
        assertEquals("ok", heard.text());
        assertTrue(heard.messages.isEmpty());
      }
      subscription.close();
    }
  }

  /** A service whose code lacks a class answers all the same, and goes on. */
  @Test
  void anErrorInAService() throws Exception {
    List<Throwable> logged = new CopyOnWriteArrayList<>();
    Logger log = Logger.getLogger("UObjectJava");
    log.setFilter(entry -> !logged.add(entry.getThrown()));
    node.serve(
        "/lacking",
        node.definitions().service("std_srvs/Empty"),
        request -> {
          throw new NoClassDefFoundError("lost");
        });
    try (TcpRosConnection client = TcpRosConnection.to(here.getHostAddress(), node.port())) {
      client.sendHeader(
          Map.of("callerid", "/raw", "service", "/lacking", "md5sum", "*", "persistent", "1"));
      client.readHeader();
      for (int i = 1; i <= 2; i++) {
        client.write(new byte[0]);
        client.flush();
        assertEquals(0, client.readByte());
        assertEquals(
            "internal error: java.lang.NoClassDefFoundError: lost",
            StandardCharsets.UTF_8.decode(client.read()).toString());
        assertEquals(i, logged.size());
      }
    } finally {
      log.setFilter(null);
    }
  }

  /** A subscriber that has read the answer is one of those who hear what is said next. */
  @Test
  void nothingIsMissedOnceAConnectionIsMade() throws Exception {
    Publisher publisher = node.advertise("/said", text, Qos.DEFAULT, new Publisher.Listener() {});
    for (int i = 0; i < 100; i++) {
      try (TcpRosConnection subscriber = TcpRosConnection.to(here.getHostAddress(), node.port())) {
        subscriber.sendHeader(header());
        subscriber.readHeader();
        publisher.publish(new UDictionary().with("data", "" + i % 10));
        ByteBuffer message = Awaited.value(read(subscriber));
        assertEquals('0' + i % 10, message.slice().get(4));
      }
    }
  }

  private static CompletableFuture<ByteBuffer> read(TcpRosConnection connection) {
    CompletableFuture<ByteBuffer> message = new CompletableFuture<>();
    Threads.start("test", () -> message.complete(connection.read()));
    return message;
  }

  /** A master whose answer to a new subscriber comes after the news that made it out of date. */
  @Test
  void anAnswerOfTheMasterThatNewsOvertook() throws Exception {
    node.close();
    AtomicInteger asked = new AtomicInteger();
    List<String> publishers = List.of("http://127.0.0.1:9/");
    try (XmlRpcServer master =
        new XmlRpcServer(
            here,
            (method, arguments) -> {
              if (!method.equals("registerSubscriber") || !arguments.get(1).equals("/said")) {
                return List.of(1, "", 0);
              }
              boolean isFirst = asked.incrementAndGet() == 1;
              if (isFirst) {
                node.updatePublishers("/said", publishers.stream().map(URI::create).toList());
              }
              return List.of(1, "", isFirst ? List.of() : publishers);
            })) {
      node = OneNodeTest.node(master.port(), "tested");
      OneSubscription said =
          (OneSubscription) node.subscribe("/said", text, Qos.DEFAULT, new Heard());
      Awaited.value(node.settled());
      assertEquals(2, asked.get());
      assertEquals(1, said.known());
    }
  }

  @Test
  void anythingAsXml() {
    String call =
        XmlRpcWriter.call(
            "requestTopic",
            List.of("/a", List.of(1, 2.5, true, "<&\u0001"), Map.of("x", new byte[] {1})));
    Random dice = new Random(9);
    for (int i = 0; i < 5000; i++) {
      byte[] bytes = call.getBytes(StandardCharsets.UTF_8);
      for (int k = dice.nextInt(4); k >= 0; k--) {
        bytes[dice.nextInt(bytes.length)] = (byte) "<>/avr\0&;é".charAt(dice.nextInt(10));
      }
      try {
        XmlRpcReader.call(Arrays.copyOf(bytes, dice.nextInt(bytes.length + 1)));
      } catch (XmlRpcException e) {
        // Refused: that is all it may do.
        continue;
      }
    }
  }
}

package org.urbi.ros.one;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.TypeHash;
import urbi.UBinary;

/** A node that reads nothing until all has been published: more than the system keeps for it. */
class SlowSubscriberTest {
  private static final int COUNT = 2000;
  private static final int SIZE = 16_384;
  private static final int SMALL = 4096;

  /** What it gets at last, of the messages 0, 1… if so many may wait. */
  private static List<Integer> heard(int depth) throws Exception {
    try (OneNode node = OneNodeTest.node(1, "tested")) {
      MessageType type = node.definitions().message("std_msgs/UInt8MultiArray");
      Publisher publisher =
          node.advertise(
              "/much",
              type,
              new Qos(true, false, depth, Duration.ZERO, false),
              new Publisher.Listener() {});
      Socket socket = new Socket();
      socket.setReceiveBufferSize(SMALL);
      socket.connect(new InetSocketAddress("127.0.0.1", node.port()));
      try (TcpRosConnection slow = new TcpRosConnection(socket)) {
        slow.sendHeader(header(type));
        slow.readHeader();
        for (int i = 0; i < COUNT; i++) {
          byte[] data = ByteBuffer.allocate(SIZE).putInt(SIZE - Integer.BYTES, i).array();
          publisher.publish(Templates.of(type).with("data", new UBinary(data)));
        }
        List<Integer> got = new ArrayList<>();
        do {
          ByteBuffer message = slow.read();
          int tail = message.position() + message.remaining() - Integer.BYTES;
          got.add(Integer.reverseBytes(message.getInt(tail)));
        } while (got.getLast() < COUNT - 1);
        return got;
      }
    }
  }

  private static Map<String, String> header(MessageType type) {
    Map<String, String> header = new LinkedHashMap<>();
    header.put("callerid", "/slow");
    header.put("topic", "/much");
    header.put("type", "std_msgs/UInt8MultiArray");
    header.put("md5sum", TypeHash.md5(type));
    return header;
  }

  @Test
  void asManyWaitAsAreWanted() throws Exception {
    assertEquals(IntStream.range(0, COUNT).boxed().toList(), heard(COUNT));
  }

  @Test
  void theOldestAreDropped() throws Exception {
    List<Integer> got = heard(5);
    assertTrue(got.size() < COUNT, got::toString);
    List<Integer> sorted = new ArrayList<>(got);
    Collections.sort(sorted);
    assertEquals(sorted, got);
    assertEquals(
        IntStream.range(COUNT - 5, COUNT).boxed().toList(),
        got.subList(got.size() - 5, got.size()));
  }
}

package org.urbi.ros.one;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.ros.FreePorts;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.TypeHash;
import urbi.UBinary;
import urbi.UDictionary;
import urbi.UValue;

/**
 * How often the bytes of an image are copied between a Binary and the system: each copy in Java
 * needs memory, and all that this program takes is counted. The peers are bare sockets, which take
 * none.
 */
class CopiesTest {
  private static final int SIZE = 640 * 480 * 3;
  private static final int IMAGES = 40;

  /** What else there is in a message, and whatever happens meanwhile. */
  private static final double MOST = 1.2 * SIZE;

  private final InetAddress here = InetAddress.getLoopbackAddress();
  private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private OneNode node;
  private MessageType image;
  private UDictionary message;

  @BeforeEach
  void start() throws IOException {
    node = OneNodeTest.node(FreePorts.next(), "tested");
    image = node.definitions().message("sensor_msgs/Image");
    message = Templates.of(image);
    message.put("data", new UValue(new UBinary(new byte[SIZE])));
  }

  @AfterEach
  void end() {
    node.close();
  }

  private byte[] header() {
    Map<String, String> header = new LinkedHashMap<>();
    header.put("callerid", "/raw");
    header.put("topic", "/seen");
    header.put("type", "sensor_msgs/Image");
    header.put("md5sum", TypeHash.md5(image));
    return ConnectionHeader.write(header);
  }

  private interface Image {
    void pass() throws Exception;
  }

  /** The bytes that an image takes, once the first ones have passed. */
  private double allocated(Image each) throws Exception {
    for (int i = 0; i < IMAGES; i++) {
      each.pass();
    }
    long before = threads.getTotalThreadAllocatedBytes();
    for (int i = 0; i < IMAGES; i++) {
      each.pass();
    }
    return (threads.getTotalThreadAllocatedBytes() - before) / (double) IMAGES;
  }

  private static void skip(DataInputStream in) throws Exception {
    in.skipNBytes(Integer.reverseBytes(in.readInt()));
  }

  @Test
  void whatIsSentIsCopiedOnce() throws Exception {
    Publisher publisher = node.advertise("/seen", image, Qos.DEFAULT, new Publisher.Listener() {});
    try (Socket subscriber = new Socket(here, node.port())) {
      DataInputStream in = new DataInputStream(subscriber.getInputStream());
      subscriber.getOutputStream().write(header());
      skip(in);
      double bytes =
          allocated(() -> {
            publisher.publish(message);
            skip(in);
          });
      assertTrue(bytes < MOST, bytes / SIZE + " images");
    }
  }

  @Test
  void whatIsHeardIsCopiedOnce() throws Exception {
    byte[] sent = MessageCodec.of(image).encode(message);
    byte[] length =
        ByteBuffer.allocate(4).order(ByteOrder.LITTLE_ENDIAN).putInt(sent.length).array();
    Heard heard = new Heard();
    try (ServerSocket data = new ServerSocket(0, 50, here);
        XmlRpcServer slave =
            new XmlRpcServer(
                here,
                (method, arguments) ->
                    List.of(1, "", List.of("TCPROS", here.getHostAddress(), data.getLocalPort())));
        Subscription subscription = node.subscribe("/seen", image, Qos.DEFAULT, heard)) {
      node.updatePublishers("/seen", List.of(URI.create("http://127.0.0.1:" + slave.port() + "/")));
      try (Socket publisher = data.accept()) {
        skip(new DataInputStream(publisher.getInputStream()));
        OutputStream out = publisher.getOutputStream();
        out.write(header());
        double bytes =
            allocated(() -> {
              out.write(length);
              out.write(sent);
              heard.messages.take();
            });
        assertTrue(bytes < MOST, bytes / SIZE + " images");
      }
    }
  }
}

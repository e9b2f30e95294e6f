package org.urbi.ros.rtps;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.ros.rtps.Neighbourhood.NO_DATA;
import static org.urbi.ros.rtps.Neighbourhood.TYPE;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.ros.rtps.Neighbourhood.Receiving;
import org.urbi.ros.rtps.Neighbourhood.Sending;

/**
 * With ROS 2 itself, two of its distributions, and with another implementation of DDS:
 * std_msgs/String both ways.
 */
class RealPeersTest {
  /** All is kept: a peer that the machine lets wait for a moment would miss what is overwritten. */
  private static final EndpointQos QOS = EndpointQos.reliable(EndpointQos.KEEP_ALL);

  private static final long LONG = TimeUnit.MINUTES.toNanos(1);

  /** As ROS 2 writes a string: after a header of four bytes, its length with the 0 that ends it. */
  private static ByteBuffer string(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    ByteBuffer out = ByteBuffer.allocate(9 + bytes.length).order(ByteOrder.LITTLE_ENDIAN);
    return out.putInt(0x00000100).putInt(bytes.length + 1).put(bytes).put((byte) 0).flip();
  }

  private static String string(ByteBuffer payload) {
    byte[] bytes = new byte[payload.order(ByteOrder.LITTLE_ENDIAN).getInt(4) - 1];
    payload.get(8, bytes);
    return new String(bytes, StandardCharsets.UTF_8);
  }

  @ParameterizedTest
  @ValueSource(strings = {"cyclone", "kilted", "jazzy"})
  void allArrives(String environment) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = new Peer(environment, domain.domain)) {
      Participant participant = domain.open();
      send(participant, peer, "small", 5000, 1000);
      send(participant, peer, "large", 20, 1 << 20);
      receive(participant, peer, "back_small", 5000, 1000, 2000);
      receive(participant, peer, "back_large", 20, 1 << 20, 10);
      domain.awaitTold("found rt/back_large");
      peer.kill();
    }
  }

  private static void send(Participant participant, Peer peer, String topic, int count, int size)
      throws Exception {
    Sending sending = new Sending();
    Writer writer = participant.writer("rt/" + topic, TYPE, QOS, NO_DATA, sending);
    peer.say("subscribe " + topic + " " + count);
    peer.expect("subscribed");
    sending.awaitMatched();
    String text = "x".repeat(size);
    for (int i = 0; i < count; i++) {
      assertTrue(writer.awaitRoom(LONG));
      writer.write(string(i + ":" + text));
    }
    peer.expect("got " + count + " in order");
    writer.close();
  }

  private static void receive(
      Participant participant, Peer peer, String topic, int count, int size, int rate)
      throws Exception {
    Receiving receiving = new Receiving(true);
    Reader reader = participant.reader("rt/" + topic, TYPE, QOS, NO_DATA, receiving);
    peer.say("publish " + topic + " " + count + " " + size + " " + rate);
    peer.expect("matched");
    String text = ":" + "x".repeat(size);
    for (int i = 0; i < count; i++) assertEquals(i + text, string(receiving.next().payload()));
    peer.expect("published");
    reader.close();
  }
}

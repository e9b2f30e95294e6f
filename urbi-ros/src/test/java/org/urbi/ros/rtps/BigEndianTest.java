package org.urbi.ros.rtps;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.urbi.ros.rtps.Neighbourhood.NO_DATA;
import static org.urbi.ros.rtps.Neighbourhood.TYPE;

import java.net.InetSocketAddress;
import java.net.StandardProtocolFamily;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.urbi.ros.rtps.Neighbourhood.Receiving;

/** A peer whose numbers have the other byte order, written by hand from the specification. */
class BigEndianTest {
  private static final int[] NAME = {0x01020304, 0x05060708, 0x090a0b0c};
  private static final int WRITER = 0x00000103;

  private final ByteBuffer out = ByteBuffer.allocate(2000);
  private int start;

  private BigEndianTest begin() {
    out.clear();
    out.put("RTPS".getBytes(StandardCharsets.US_ASCII)).put(new byte[] {2, 1, 9, 9});
    for (int each : NAME) out.putInt(each);
    return this;
  }

  private void data(int writer, long sequence, Runnable payload) {
    out.put((byte) 0x15).put((byte) 0x04).putShort((short) 0);
    start = out.position();
    out.putShort((short) 0).putShort((short) 16).putInt(0).putInt(writer).putLong(sequence);
    payload.run();
    out.putShort(start - 2, (short) (out.position() - start));
  }

  private void heartbeat(int reader, int writer, long first, long last, int count) {
    out.put((byte) 0x07).put((byte) 0).putShort((short) 28);
    out.putInt(reader).putInt(writer).putLong(first).putLong(last).putInt(count);
  }

  private void parameter(int id, int length) {
    out.putShort((short) id).putShort((short) length);
  }

  private void locator(int id, InetSocketAddress at) {
    parameter(id, 24);
    out.putInt(1).putInt(at.getPort()).putLong(0).putInt(0).put(new byte[] {127, 0, 0, 1});
  }

  private void string(int id, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    int padded = (4 + bytes.length + 1 + 3) / 4 * 4;
    parameter(id, padded);
    int end = out.position() + padded;
    out.putInt(bytes.length + 1).put(bytes);
    while (out.position() < end) out.put((byte) 0);
  }

  private void guid(int id, int entity) {
    parameter(id, 16);
    for (int each : NAME) out.putInt(each);
    out.putInt(entity);
  }

  @Test
  void isUnderstood() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        DatagramChannel socket = DatagramChannel.open(StandardProtocolFamily.INET)) {
      socket.bind(new InetSocketAddress("127.0.0.1", 0));
      InetSocketAddress own = (InetSocketAddress) socket.getLocalAddress();
      Participant participant = domain.open();
      Receiving receiving = new Receiving(true);
      Reader reader =
          participant.reader("rt/x", TYPE, EndpointQos.reliable(10), NO_DATA, receiving);
      InetSocketAddress discovery = participant.info().discovery().getFirst();
      begin().data(0x000100c2, 1, () -> describeParticipant(own));
      socket.send(out.flip(), discovery);
      domain.awaitTold("found 01020304.05060708.090a0b0c");
      assertEquals("grand", participant.participants().getFirst().name());
      begin().data(0x000003c2, 1, this::describeWriter);
      heartbeat(0x000003c7, 0x000003c2, 1, 1, 1);
      socket.send(out.flip(), discovery);
      receiving.awaitMatched();
      EndpointInfo info = participant.endpoints().getFirst();
      assertArrayEquals("hi".getBytes(StandardCharsets.UTF_8), info.userData());
      assertEquals(1_500_000_000L, info.qos().deadline());
      begin().heartbeat(reader.guid().entity(), WRITER, 1, 0, 1);
      data(WRITER, 1, () -> out.putInt(0).putInt(77));
      socket.send(out.flip(), participant.info().user().getFirst());
      Sample sample = receiving.next();
      assertEquals(77, sample.payload().getInt(4));
      assertEquals(1, sample.identity().sequence());
    }
  }

  private void describeParticipant(InetSocketAddress own) {
    out.putInt(0x00020000);
    guid(0x0050, 0x000001c1);
    string(0x0062, "grand");
    locator(0x0032, own);
    locator(0x0031, own);
    parameter(0x0058, 4);
    out.putInt(0xc3f);
    parameter(0x0002, 8);
    out.putInt(30).putInt(0);
    parameter(0x0001, 0);
  }

  private void describeWriter() {
    out.putInt(0x00020000);
    guid(0x005a, WRITER);
    string(0x0005, "rt/x");
    string(0x0007, TYPE);
    parameter(0x001a, 12);
    out.putInt(2).putInt(0).putInt(0);
    parameter(0x0023, 8);
    out.putInt(1).putInt(0x80000000);
    parameter(0x002c, 8);
    out.putInt(2).put((byte) 'h').put((byte) 'i').putShort((short) 0);
    parameter(0x8042, 4);
    out.putInt(0);
    parameter(0x0001, 0);
  }
}

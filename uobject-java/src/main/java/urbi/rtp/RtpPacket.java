package urbi.rtp;

import java.nio.ByteBuffer;
import org.jspecify.annotations.Nullable;

/**
 * A datagram with a part of a frame: the fixed header of RTP (RFC 3550, section 5.1), and after it
 * the token, the variable, and which of how many parts it is.
 *
 * @param sequence its number in its stream, modulo 2^16
 * @param timestamp when the frame was sent, at 90 kHz; the same for all its parts
 * @param ssrc the stream
 * @param token what shows that it is no stranger's
 * @param index which part of the frame, from 0 on
 * @param count of how many; the last one has the marker
 * @param data the part
 */
record RtpPacket(
    int sequence,
    int timestamp,
    int ssrc,
    long token,
    int variable,
    int index,
    int count,
    byte[] data) {
  /** How many bytes precede the data. */
  static final int HEADER = 28;

  /** More parts than this a frame has not: they have to be a small part of the numbers. */
  static final int MAX_PARTS = 1 << 14;

  private static final int VERSION = 0x80;
  private static final int PAYLOAD_TYPE = 96;
  private static final int MARKER = 0x80;

  byte[] toBytes() {
    return ByteBuffer.allocate(HEADER + data.length)
        .put((byte) VERSION)
        .put((byte) (index == count - 1 ? PAYLOAD_TYPE | MARKER : PAYLOAD_TYPE))
        .putShort((short) sequence)
        .putInt(timestamp)
        .putInt(ssrc)
        .putLong(token)
        .putInt(variable)
        .putShort((short) index)
        .putShort((short) count)
        .put(data)
        .array();
  }

  /** The packet that these bytes hold; null if they are not a packet. */
  static @Nullable RtpPacket read(byte[] bytes, int length) {
    if (length <= HEADER) {
      return null;
    }
    ByteBuffer in = ByteBuffer.wrap(bytes, 0, length);
    int first = in.get() & 0xff;
    int second = in.get() & 0xff;
    int sequence = in.getShort() & 0xffff;
    int timestamp = in.getInt();
    int ssrc = in.getInt();
    long token = in.getLong();
    int variable = in.getInt();
    int index = in.getShort() & 0xffff;
    int count = in.getShort() & 0xffff;
    boolean last = index == count - 1;
    if (first != VERSION
        || second != (last ? PAYLOAD_TYPE | MARKER : PAYLOAD_TYPE)
        || index >= count
        || count > MAX_PARTS) {
      return null;
    }
    byte[] data = new byte[in.remaining()];
    in.get(data);
    return new RtpPacket(sequence, timestamp, ssrc, token, variable, index, count, data);
  }
}

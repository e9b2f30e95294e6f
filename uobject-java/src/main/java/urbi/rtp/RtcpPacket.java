package urbi.rtp;

import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * A control datagram: a report of the received datagrams (RFC 3550, section 6.4.2), or a probe that
 * tests whether datagrams arrive at all (APP, section 6.7). It uses the same ports as the data (RFC
 * 5761).
 *
 * @param kind what it is
 * @param ssrc who has sent it
 * @param token what shows that it is no stranger's
 * @param highest of a report: the highest sequence number of each stream
 */
record RtcpPacket(Kind kind, int ssrc, long token, Map<Integer, Integer> highest) {
  enum Kind {
    /** Tells what has come. */
    REPORT,
    /** Wants to be answered. */
    PROBE,
    /** The answer. */
    ANSWER
  }

  /** A report tells of so many streams at most. */
  static final int MAX_BLOCKS = 31;

  private static final int VERSION = 0x80;
  private static final int RECEIVER_REPORT = 201;
  private static final int APPLICATION = 204;
  private static final int NAME = 0x55524249;
  private static final int BLOCK = 24;
  private static final int HEADER = 8;

  /** Whether bytes are such a packet, rather than one with data. */
  static boolean is(byte[] bytes, int length) {
    int type = length < 2 ? 0 : bytes[1] & 0xff;
    return type >= 192 && type <= 223;
  }

  static RtcpPacket probe(Kind kind, int ssrc, long token) {
    return new RtcpPacket(kind, ssrc, token, Map.of());
  }

  byte[] toBytes() {
    boolean report = kind == Kind.REPORT;
    int length = HEADER + (report ? BLOCK * highest.size() : Integer.BYTES) + Long.BYTES;
    int low = report ? highest.size() : kind.ordinal();
    ByteBuffer out =
        ByteBuffer.allocate(length)
            .put((byte) (VERSION | low))
            .put((byte) (report ? RECEIVER_REPORT : APPLICATION))
            .putShort((short) (length / Integer.BYTES - 1))
            .putInt(ssrc);
    if (report) {
      // Nobody asks for loss and jitter: what matters is how far the other side has read.
      highest.forEach((stream, sequence) ->
          out.putInt(stream).putInt(0).putInt(sequence).putInt(0).putInt(0).putInt(0));
    } else {
      out.putInt(NAME);
    }
    return out.putLong(token).array();
  }

  /** The packet that these bytes hold; null if they are not a packet. */
  static @Nullable RtcpPacket read(byte[] bytes, int length) {
    if (length < HEADER + Long.BYTES) {
      return null;
    }
    ByteBuffer in = ByteBuffer.wrap(bytes, 0, length);
    int first = in.get() & 0xff;
    int type = in.get() & 0xff;
    int words = in.getShort() & 0xffff;
    int ssrc = in.getInt();
    int low = first & 0x1f;
    if ((first & 0xe0) != VERSION || (words + 1) * Integer.BYTES != length) {
      return null;
    }
    if (type == RECEIVER_REPORT && length == HEADER + BLOCK * low + Long.BYTES) {
      Map<Integer, Integer> highest = new LinkedHashMap<>();
      for (int i = 0; i < low; i++) {
        int stream = in.getInt();
        in.getInt();
        highest.put(stream, in.getInt());
        in.position(in.position() + 3 * Integer.BYTES);
      }
      return new RtcpPacket(Kind.REPORT, ssrc, in.getLong(), highest);
    }
    if (type == APPLICATION
        && length == HEADER + Integer.BYTES + Long.BYTES
        && in.getInt() == NAME
        && (low == Kind.PROBE.ordinal() || low == Kind.ANSWER.ordinal())) {
      return probe(Kind.values()[low], ssrc, in.getLong());
    }
    return null;
  }
}

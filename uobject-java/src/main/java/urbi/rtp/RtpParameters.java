package urbi.rtp;

import urbi.wire.WireInput;
import urbi.wire.WireOutput;

/**
 * The parameters that one side sends to the other, over the connection, about the datagrams that it
 * receives and sends.
 *
 * @param port where it takes them
 * @param ssrc by which its own can be told; that of the first of its streams
 * @param token a secret that each datagram sent to it has to show
 * @param buffer how many bytes of datagrams may wait for it to read them
 * @param datagram the size of the largest datagram, in bytes
 */
public record RtpParameters(int port, int ssrc, long token, int buffer, int datagram) {
  /** What an Ethernet lets pass in one piece, with IPv6 and UDP around it. */
  public static final int DEFAULT_DATAGRAM = 1440;

  /** Within one machine larger ones are cheaper. */
  public static final int LOOPBACK_DATAGRAM = 32_000;

  private static final int MIN_DATAGRAM = 256;
  private static final int MAX_DATAGRAM = 60_000;
  private static final int MAX_WINDOW = 1 << 20;
  private static final int MIN_BUFFER = 16 << 10;

  /** Terms out of their range are brought into it. */
  public RtpParameters {
    buffer = Math.max(MIN_BUFFER, buffer);
    datagram = Math.clamp(datagram, MIN_DATAGRAM, MAX_DATAGRAM);
  }

  /**
   * How many bytes may be on their way to this side without its having reported them. The system
   * counts the room that it takes for a datagram as well, so that it is a part of the buffer only.
   */
  int window() {
    return Math.min(MAX_WINDOW, buffer / 8 * 3);
  }

  /** Writes them as fields of a frame. */
  public WireOutput write(WireOutput out) {
    return out.size(port).size(ssrc).number(token).size(buffer).size(datagram);
  }

  /** Reads what {@link #write} has written. */
  public static RtpParameters read(WireInput in) {
    return new RtpParameters(in.size() & 0xffff, in.size(), in.number(), in.size(), in.size());
  }
}

package urbi.rtp;

import java.time.Duration;

/**
 * How a process sends datagrams.
 *
 * @param datagram the size of the largest one, in bytes; 0 for one that suits the way to the server
 * @param port to which port of the server they are sent; 0 for that which the server names, which
 *     is the right one unless something between the two forwards another
 * @param patience how long datagrams may take until they are thought not to get through
 */
public record RtpOptions(int datagram, int port, Duration patience) {
  /** The name of the module that switches datagrams on. */
  public static final String MODULE = "urbi/rtp";

  /** What suits most. */
  public static final RtpOptions DEFAULT = new RtpOptions(0, 0, Duration.ofSeconds(2));
}

package org.urbi.server.net;

/**
 * What one client may ask of the server.
 *
 * @param input how many bytes may be received and not yet taken by the kernel; beyond, the server
 *     stops reading and TCP makes the client wait
 * @param output how many bytes may be sent by the kernel and not yet taken by the client; beyond,
 *     the client is let go
 * @param secondsAfterEnd how long a client that has ended its stream may wait for its jobs to end;
 *     TCP cannot tell whether it still listens or is gone
 */
public record Limits(int input, long output, int secondsAfterEnd) {
  /** What suits a server: 1 MiB of input, 16 MiB of output, half a minute. */
  public static final Limits DEFAULT = new Limits(1 << 20, 16L << 20, 30);
}

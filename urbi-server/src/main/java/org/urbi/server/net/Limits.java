package org.urbi.server.net;

/**
 * How many bytes one client may keep waiting.
 *
 * @param input received and not yet taken by the kernel; beyond, the server stops reading and TCP
 *     makes the client wait
 * @param output sent by the kernel and not yet taken by the client; beyond, the client is let go
 */
public record Limits(int input, long output) {
  /** What suits a server: 1 MiB of input, 16 MiB of output. */
  public static final Limits DEFAULT = new Limits(1 << 20, 16L << 20);
}

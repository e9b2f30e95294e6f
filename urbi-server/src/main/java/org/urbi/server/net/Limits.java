package org.urbi.server.net;

/**
 * The limits for clients.
 *
 * @param input how many bytes may be received and not yet taken by the kernel; beyond, the server
 *     stops reading and TCP makes the client wait
 * @param output how many bytes may be sent by the kernel and not yet taken by the client; beyond,
 *     the client is let go
 * @param totalOutput how many bytes may wait so for all of them together; beyond, whoever has more
 *     than his share of it is let go when more comes
 * @param secondsAfterEnd how long a client that has ended its stream may have statements that
 *     compute; TCP cannot tell whether it still listens or is gone
 * @param connections how many clients there may be at a time; 0 for as many as there are file
 *     descriptors
 * @param budget what the lobby of a client may have, as {@link org.urbi.kernel.Client#budget} says
 */
public record Limits(
    int input, long output, long totalOutput, int secondsAfterEnd, int connections, String budget) {
  /**
   * The limits of a server: 1 MiB of input, 16 MiB of output, a quarter of the memory for the
   * output of all, ten seconds, any number of clients.
   */
  public static final Limits DEFAULT =
      new Limits(1 << 20, 16L << 20, Runtime.getRuntime().maxMemory() / 4, 10, 0, "");

  /** The same limits with that number of clients; 0 for as many as there are file descriptors. */
  public Limits withConnections(int most) {
    return new Limits(input, output, totalOutput, secondsAfterEnd, most, budget);
  }

  /** The same limits with those budgets. */
  public Limits withBudget(String other) {
    return new Limits(input, output, totalOutput, secondsAfterEnd, connections, other);
  }

  /** The same limits with that total output. */
  public Limits withTotalOutput(long most) {
    return new Limits(input, output, most, secondsAfterEnd, connections, budget);
  }
}

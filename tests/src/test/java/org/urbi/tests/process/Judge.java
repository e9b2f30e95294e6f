package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.List;

/**
 * A client that must be answered within a second, whatever other clients do.
 *
 * <p>A busy machine makes everything late, which says nothing of the server. So what counts is the
 * time by the clock less the time for which a thread that the answer needs could have run but had
 * no processor (see {@link Starvation}): the thread of the kernel, of the network, of the garbage
 * collector, the one that looks after the memory (the kernel waits for it where that is scarce),
 * and of this client. What the server itself does in that second counts in full: work for others,
 * waiting, collecting garbage.
 */
final class Judge implements AutoCloseable {
  private static final long LIMIT_MILLISECONDS = 1000;

  private static final int NANOSECONDS_PER_MILLISECOND = 1_000_000;

  /** What the names of the threads begin with that an answer needs, each of them. */
  private static final String[] NEEDED = {
    "urbi-kernel", "urbi-network", "urbi-memory", "VM Thread"
  };

  private final ServerProcess server;
  private final ConsoleClient client;

  private Judge(ServerProcess server) throws IOException {
    this.server = server;
    client = server.connect();
    // The first answer pays for classes that are loaded.
    client.answers("1|;");
  }

  /** Connects to a server. */
  static Judge of(ServerProcess server) throws IOException {
    return new Judge(server);
  }

  /** Asks something, and fails if the answer takes too long; says after what that was. */
  void isAnswered(String after) throws IOException {
    Starvation starvation = Starvation.begin(server.pid(), NEEDED);
    long began = System.nanoTime();
    try {
      assertEquals(List.of(), client.answers("1|;"));
    } catch (IOException | AssertionError e) {
      throw new AssertionError("after " + after + ": " + server.text(), e);
    }
    long wall = (System.nanoTime() - began) / NANOSECONDS_PER_MILLISECOND;
    long took = wall - starvation.milliseconds();
    if (took > LIMIT_MILLISECONDS) {
      throw new AssertionError(
          "answered after "
              + took
              + " ms ("
              + wall
              + " by the clock), after "
              + after
              + ": "
              + server.text());
    }
  }

  @Override
  public void close() throws IOException {
    client.close();
  }
}

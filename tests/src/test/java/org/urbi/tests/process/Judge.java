package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * A client that must be answered within a second, whatever other clients do.
 *
 * <p>A busy machine makes everything late, which says nothing of the server. So what counts is the
 * time by the clock less the time for which a thread that the answer needs could have run but had
 * no processor: the thread of the kernel, of the network, of the garbage collector, the one that
 * looks after the memory (the kernel waits for it where that is scarce), and of this client. The
 * system counts that for each thread ({@code schedstat}; where it does not, nothing is taken off).
 * What the server itself does in that second counts in full: work for others, waiting, collecting
 * garbage.
 */
final class Judge implements AutoCloseable {
  private static final long LIMIT_MILLISECONDS = 1000;

  private static final int NANOSECONDS_PER_MILLISECOND = 1_000_000;

  private static final Path OWN_THREAD = Path.of("/proc/thread-self/schedstat");

  private final ServerProcess server;
  private final ConsoleClient client;
  private final List<Path> threads;

  private Judge(ServerProcess server) throws IOException {
    this.server = server;
    client = server.connect();
    threads = threadsOf(server.pid());
    // The first answer pays for classes that are loaded.
    client.answers("1|;");
  }

  /** Connects to a server. */
  static Judge of(ServerProcess server) throws IOException {
    return new Judge(server);
  }

  /** The counters of the threads that an answer needs. */
  private static List<Path> threadsOf(long pid) throws IOException {
    Path tasks = Path.of("/proc/" + pid + "/task");
    if (!Files.exists(OWN_THREAD)) {
      return List.of();
    }
    try (Stream<Path> all = Files.list(tasks)) {
      return all.filter(Judge::isNeeded).map(task -> task.resolve("schedstat")).toList();
    }
  }

  private static boolean isNeeded(Path task) {
    try {
      String name = Files.readString(task.resolve("comm")).strip();
      return name.startsWith("urbi-kernel")
          || name.startsWith("urbi-network")
          || name.startsWith("urbi-memory")
          || name.startsWith("VM Thread");
    } catch (IOException e) {
      // It has ended.
      return false;
    }
  }

  /** How long these threads have waited for a processor, in milliseconds. */
  private long starved() {
    long nanoseconds = 0;
    for (Path thread : threads) {
      nanoseconds += waitedFor(thread);
    }
    return (nanoseconds + waitedFor(OWN_THREAD)) / NANOSECONDS_PER_MILLISECOND;
  }

  /** The second number of that file. */
  private static long waitedFor(Path thread) {
    try {
      return Files.exists(thread) ? Long.parseLong(Files.readString(thread).split(" ")[1]) : 0;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Asks something, and fails if the answer takes too long; says after what that was. */
  void isAnswered(String after) {
    long starved = starved();
    long began = System.nanoTime();
    try {
      assertEquals(List.of(), client.answers("1|;"));
    } catch (IOException | AssertionError e) {
      throw new AssertionError("after " + after + ": " + server.text(), e);
    }
    long wall = (System.nanoTime() - began) / NANOSECONDS_PER_MILLISECOND;
    long took = wall - (starved() - starved);
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

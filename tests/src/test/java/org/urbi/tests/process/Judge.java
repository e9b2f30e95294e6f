package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * A client that must be answered within a second, whatever other clients do.
 *
 * <p>A busy machine makes everything late, which says nothing of the server. So what counts is the
 * time by the clock less the time for which a thread that the answer needs could have run but had
 * no processor: the thread of the kernel, of the network, of the garbage collector (of those that
 * collect side by side, the one that has waited longest), the one that looks after the memory (the
 * kernel waits for it where that is scarce), and of this client. The system counts that for each
 * thread ({@code schedstat}; where it does not, nothing is taken off). What the server itself does
 * in that second counts in full: work for others, waiting, collecting garbage.
 */
final class Judge implements AutoCloseable {
  private static final long LIMIT_MILLISECONDS = 1000;

  private static final int NANOSECONDS_PER_MILLISECOND = 1_000_000;

  private static final Path OWN_THREAD = Path.of("/proc/thread-self");

  /** What the names of the threads begin with that an answer needs, each of them. */
  private static final List<String> NEEDED =
      List.of("urbi-kernel", "urbi-network", "urbi-memory", "VM Thread");

  /** The same of those that collect garbage side by side, while all others wait for them. */
  private static final String COLLECTOR = "GC Thread";

  private final ServerProcess server;
  private final ConsoleClient client;
  private final Path tasks;

  private Judge(ServerProcess server) throws IOException {
    this.server = server;
    client = server.connect();
    tasks = Path.of("/proc/" + server.pid() + "/task");
    // The first answer pays for classes that are loaded.
    client.answers("1|;");
  }

  /** Connects to a server. */
  static Judge of(ServerProcess server) throws IOException {
    return new Judge(server);
  }

  /** How long each thread has waited for a processor so far, in nanoseconds. */
  private Map<Path, Long> waits() throws IOException {
    Map<Path, Long> waits = new HashMap<>();
    if (Files.exists(OWN_THREAD.resolve("schedstat"))) {
      waits.put(OWN_THREAD, waitedFor(OWN_THREAD));
      try (Stream<Path> all = Files.list(tasks)) {
        all.forEach(task -> waits.put(task, waitedFor(task)));
      }
    }
    return waits;
  }

  /** The second number of that file. */
  private static long waitedFor(Path thread) {
    try {
      return Long.parseLong(Files.readString(thread.resolve("schedstat")).split(" ")[1]);
    } catch (IOException e) {
      // It has ended.
      return 0;
    }
  }

  /** How long the threads that an answer needs have waited since then, in milliseconds. */
  private long starved(Map<Path, Long> before) throws IOException {
    long needed = 0;
    long collecting = 0;
    for (Map.Entry<Path, Long> each : waits().entrySet()) {
      Path thread = each.getKey();
      // Those that collect are made when there is much to do.
      long waited = each.getValue() - before.getOrDefault(thread, 0L);
      String name = name(thread);
      if (thread.equals(OWN_THREAD) || NEEDED.stream().anyMatch(name::startsWith)) {
        needed += waited;
      } else if (name.startsWith(COLLECTOR)) {
        collecting = Math.max(collecting, waited);
      }
    }
    return (needed + collecting) / NANOSECONDS_PER_MILLISECOND;
  }

  private static String name(Path thread) {
    try {
      return Files.readString(thread.resolve("comm"));
    } catch (IOException e) {
      // It has ended.
      return "";
    }
  }

  /** Asks something, and fails if the answer takes too long; says after what that was. */
  void isAnswered(String after) throws IOException {
    Map<Path, Long> before = waits();
    long began = System.nanoTime();
    try {
      assertEquals(List.of(), client.answers("1|;"));
    } catch (IOException | AssertionError e) {
      throw new AssertionError("after " + after + ": " + server.text(), e);
    }
    long wall = (System.nanoTime() - began) / NANOSECONDS_PER_MILLISECOND;
    long took = wall - starved(before);
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

package org.urbi.tests.process;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * For how long threads could have run but had no processor, because the machine is busy with
 * something else. The system counts that for each thread ({@code schedstat}; where it does not,
 * nothing is counted). Of those that collect garbage side by side, while all others wait, what
 * counts is the one that has waited longest.
 */
final class Starvation {
  private static final Path OWN_THREAD = Path.of("/proc/thread-self");

  /** What the names of those begin with that collect garbage side by side. */
  private static final String COLLECTOR = "GC Thread";

  private final Path tasks;
  private final List<String> needed;
  private final Map<Path, Long> before;

  private Starvation(long pid, List<String> needed) throws IOException {
    tasks = Path.of("/proc/" + pid + "/task");
    this.needed = needed;
    before = waits();
  }

  /**
   * Begins to count.
   *
   * @param pid a process
   * @param needed what the names of its threads begin with that count, beside the calling thread
   */
  static Starvation begin(long pid, String... needed) throws IOException {
    return new Starvation(pid, List.of(needed));
  }

  /** How long each thread has waited for a processor so far, in nanoseconds. */
  private Map<Path, Long> waits() throws IOException {
    Map<Path, Long> waits = new HashMap<>();
    if (Files.exists(OWN_THREAD.resolve("schedstat"))) {
      waits.put(OWN_THREAD, waitedFor(OWN_THREAD));
      try (Stream<Path> all = Files.list(tasks)) {
        all.forEach(task -> waits.put(task, waitedFor(task)));
      } catch (UncheckedIOException e) {
        throw e.getCause();
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

  /**
   * How long those threads have waited since it began, in milliseconds.
   *
   * @throws IOException if the process has ended
   */
  long milliseconds() throws IOException {
    long waited = 0;
    long collecting = 0;
    for (Map.Entry<Path, Long> each : waits().entrySet()) {
      Path thread = each.getKey();
      // Those that collect are made when there is much to do.
      long more = each.getValue() - before.getOrDefault(thread, 0L);
      String name = name(thread);
      if (thread.equals(OWN_THREAD) || needed.stream().anyMatch(name::startsWith)) {
        waited += more;
      } else if (name.startsWith(COLLECTOR)) {
        collecting = Math.max(collecting, more);
      }
    }
    return TimeUnit.NANOSECONDS.toMillis(waited + collecting);
  }

  private static String name(Path thread) {
    try {
      return Files.readString(thread.resolve("comm"));
    } catch (IOException e) {
      // It has ended.
      return "";
    }
  }
}

package org.urbi.bench.soak;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;

/**
 * Runs many clients that connect to a server, type, flood it, make mistakes, start programs, open
 * files, use components and disconnect, and checks that the server's heap, threads, descriptors and
 * jobs return to where they were after five minutes (in a shorter run, after half of it): all
 * clients go then, and come again. The seed determines what each client does, but not how their
 * actions interleave.
 */
public final class Soak {
  private static final int SETTLE_SECONDS = 45;
  private static final int WARM_MINUTES = 5;
  private static final double GROWTH = 0.02;

  private static final int SHOWN_CLASSES = 25;

  private final int clients;
  private final long seed;
  private final SoakClient.SoakTotals totals = new SoakClient.SoakTotals();

  private Soak(int clients, long seed) {
    this.clients = clients;
    this.seed = seed;
  }

  public static void main(String[] args) {
    Program program =
        new Program("bench/soak", "Runs a server with clients that come, misbehave and vanish.")
            .option("N", "For how many minutes (default: 30, at most 600).", "--minutes")
            .option("S", "Where the random numbers begin (default: 1).", "--seed")
            .option("N", "How many clients at a time (default: 200).", "--clients");
    System.exit(program.run(args, System.out, System.err, Soak::start));
  }

  private static int start(Arguments arguments) {
    int minutes = arguments.number("--minutes", 30, 2, 600);
    Soak soak =
        new Soak(
            arguments.number("--clients", 200, 1, 1_000),
            arguments.number("--seed", 1, 0, Integer.MAX_VALUE));
    try {
      return soak.run(Path.of(System.getProperty("bench.root", ".")), minutes) ? 0 : 1;
    } catch (IOException e) {
      throw Failure.of(String.valueOf(e.getMessage()));
    }
  }

  private boolean run(Path root, int minutes) throws IOException {
    try (ServerProcess server = new ServerProcess(root)) {
      ServerProcess.Sample fresh = server.sample();
      say("fresh       " + fresh);
      // Classes are loaded, code is compiled and buffers grow once: that is no leak.
      int warm = Math.min(WARM_MINUTES, minutes / 2);
      soakConnection(server, warm * 60, 0);
      ServerProcess.Sample before = server.sample();
      Map<String, Long> classes = server.classes();
      say("warm        " + before);
      soakConnection(server, (minutes - warm) * 60, minutes);
      ServerProcess.Sample after = server.sample();
      say("afterwards  " + after);
      say(totals.toString());
      boolean met = judge(before, after, server);
      if (!met) {
        showGrowth(classes, server.classes());
      }
      return met;
    }
  }

  /** Lets the clients come for some time, and waits until the last has gone. */
  private void soakConnection(ServerProcess server, int seconds, int round) throws IOException {
    List<SoakClient> all = new ArrayList<>();
    List<Thread> threads = new ArrayList<>();
    for (int i = 0; i < clients; i++) {
      SoakClient client = new SoakClient(server.port(), seed * 1_000_003 + round + i * 31L, totals);
      all.add(client);
      threads.add(Thread.ofVirtual().start(client));
    }
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
    long next = System.nanoTime() + TimeUnit.MINUTES.toNanos(1);
    int minute = 0;
    while (System.nanoTime() < end && server.isAlive()) {
      pause(200);
      if (System.nanoTime() > next && System.nanoTime() < end) {
        next += TimeUnit.MINUTES.toNanos(1);
        say(
            "%-11s %s   answer in %d ms   %s"
                .formatted(++minute + " min", server.sample(), answerTime(server), totals));
      }
    }
    all.forEach(SoakClient::leave);
    for (Thread thread : threads) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
    pause(SETTLE_SECONDS * 1000L);
  }

  private static long answerTime(ServerProcess server) throws IOException {
    try (SoakConnection soakConnection = new SoakConnection(server.port())) {
      long start = System.nanoTime();
      soakConnection.check();
      return (System.nanoTime() - start) / 1_000_000;
    }
  }

  private boolean judge(
      ServerProcess.Sample before, ServerProcess.Sample after, ServerProcess server)
      throws IOException {
    long growth = after.heap() - before.heap();
    double allowed = before.heap() * GROWTH;
    boolean heap = growth <= allowed;
    boolean threads = after.threads() <= before.threads() * (1 + GROWTH);
    boolean descriptors = after.descriptors() <= before.descriptors() * (1 + GROWTH);
    boolean children = after.children() <= before.children();
    say(
        "descriptors %d, before %d: %s"
            .formatted(after.descriptors(), before.descriptors(), verdict(descriptors)));
    say(
        "programs    %d, before %d: %s"
            .formatted(after.children(), before.children(), verdict(children)));
    boolean jobs = after.jobs() <= before.jobs();
    say("jobs        %d, before %d: %s".formatted(after.jobs(), before.jobs(), verdict(jobs)));
    boolean answers = server.isAlive() && answerTime(server) >= 0;
    say(
        "heap        %+.2f MB, allowed %+.2f MB: %s"
            .formatted(growth / 1e6, allowed / 1e6, verdict(heap)));
    say(
        "threads     %d, before %d: %s"
            .formatted(after.threads(), before.threads(), verdict(threads)));
    if (!threads) {
      say("            " + difference(before.threadNames(), after.threadNames()));
    }
    say("answers     " + verdict(answers));
    boolean failures = totals.failures.get() == 0;
    say("failures    " + totals.failures.get() + ": " + verdict(failures));
    String log = Files.readString(server.log());
    if (!log.isBlank()) {
      List<String> lines = log.lines().toList();
      say("the server's log has %d lines, the last: %s".formatted(lines.size(), lines.getLast()));
    }
    return heap && threads && descriptors && children && jobs && answers && failures;
  }

  private static void showGrowth(Map<String, Long> before, Map<String, Long> after) {
    Map<String, Long> growth = new TreeMap<>(after);
    growth.replaceAll((name, bytes) -> bytes - before.getOrDefault(name, 0L));
    growth.entrySet().stream()
        .sorted(Map.Entry.<String, Long>comparingByValue().reversed())
        .limit(SHOWN_CLASSES)
        .forEach(entry -> say("%+10.1f kB  %s".formatted(entry.getValue() / 1e3, entry.getKey())));
  }

  private static String verdict(boolean met) {
    return met ? "met" : "MISSED";
  }

  private static Map<String, Integer> difference(
      Map<String, Integer> before, Map<String, Integer> after) {
    Map<String, Integer> difference = new TreeMap<>(after);
    before.forEach((name, count) -> difference.merge(name, -count, Integer::sum));
    difference.values().removeIf(count -> count == 0);
    return difference;
  }

  private static void say(String line) {
    System.out.println(line);
  }

  /** Waits so many milliseconds. */
  static void pause(long milliseconds) {
    try {
      Thread.sleep(milliseconds);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}

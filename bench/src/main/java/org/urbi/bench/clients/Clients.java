package org.urbi.bench.clients;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.urbi.bench.JavaProcess;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;

/**
 * Many console clients: how long their connections take, the memory of each, and how fast and how
 * evenly the busy ones are answered. Beside it, in the same run, an echo of Netty and nothing else.
 */
public final class Clients {
  private static final String QUESTION = "1|echo(42);\n";
  private static final int WARM_UP = 200;
  private static final int WARM_UP_SECONDS = 5;
  private static final int START_SECONDS = 60;

  private Clients() {}

  /** Runs all, and prints a table. */
  public static void main(String[] args) {
    Program program =
        new Program("bench/clients", "Many console clients, beside a bare Netty echo.")
            .option("N", "How many are idle (default: 10000).", "--idle")
            .option("N", "How many more are busy (default: 1000).", "--busy")
            .option("N", "How many connect at once (default: 1000).", "--burst")
            .option("N", "For how many seconds they are busy (default: 10).", "--seconds");
    System.exit(program.run(args, System.out, System.err, Clients::start));
  }

  private static int start(Arguments arguments) {
    Plan plan =
        new Plan(
            arguments.number("--idle", 10_000, 0, 100_000),
            arguments.number("--busy", 1_000, 1, 100_000),
            arguments.number("--burst", 1_000, 1, 100_000),
            arguments.number("--seconds", 10, 1, 3_600));
    Path root = Path.of(System.getProperty("bench.root", ".")).toAbsolutePath();
    try {
      Path folder = Files.createTempDirectory("urbi-clients");
      Figures console =
          plan.measure(
              folder.resolve("console"),
              List.of(root.resolve("urbi").toString(), "-q", "-P", "0", "-w"));
      Figures echo =
          plan.measure(
              folder.resolve("echo"),
              List.of(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-XX:+UseSerialGC",
                  "-cp",
                  System.getProperty("java.class.path"),
                  BareEcho.class.getName()));
      print(plan, console, echo);
      return 0;
    } catch (IOException e) {
      throw Failure.of(String.valueOf(e.getMessage()));
    }
  }

  /** What one server has shown: seconds, bytes, and answers. */
  private record Figures(long[] connects, double live, double resident, Crowd.Busy busy) {}

  private record Plan(int idle, int busy, int burst, int seconds) {
    Figures measure(Path portFile, List<String> command) throws IOException {
      List<String> whole = new ArrayList<>(command);
      whole.add(portFile.toString());
      Process process =
          new ProcessBuilder(whole)
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      process.getOutputStream().close();
      try {
        return measure(process, port(process, portFile));
      } finally {
        process.destroyForcibly();
      }
    }

    private Figures measure(Process process, int port) throws IOException {
      JavaProcess java = new JavaProcess(process.pid());
      try (Crowd crowd = new Crowd(port)) {
        crowd.connect(WARM_UP, QUESTION);
        crowd.ask(WARM_UP, QUESTION, WARM_UP_SECONDS);
      }
      try (Crowd crowd = new Crowd(port)) {
        long live = java.usedHeap();
        long resident = resident(process);
        long[] times = new long[0];
        for (int left = busy + idle; left > 0; left -= burst) {
          long[] more = crowd.connect(Math.min(left, burst), QUESTION);
          times = Arrays.copyOf(times, times.length + more.length);
          System.arraycopy(more, 0, times, times.length - more.length, more.length);
        }
        Arrays.sort(times);
        double all = idle + busy;
        double liveEach = (java.usedHeap() - live) / all;
        double residentEach = (resident(process) - resident) / all;
        return new Figures(times, liveEach, residentEach, crowd.ask(busy, QUESTION, seconds));
      }
    }
  }

  private static int port(Process process, Path file) throws IOException {
    long end = System.nanoTime() + START_SECONDS * 1_000_000_000L;
    while (!Files.exists(file)) {
      if (!process.isAlive() || System.nanoTime() > end) {
        throw new IOException("a server does not start");
      }
      try {
        Thread.sleep(20);
      } catch (InterruptedException e) {
        throw new IOException(e);
      }
    }
    return Integer.parseInt(Files.readString(file).strip());
  }

  private static long resident(Process process) throws IOException {
    for (String line : Files.readAllLines(Path.of("/proc/" + process.pid() + "/status"))) {
      if (line.startsWith("VmRSS:")) {
        return Long.parseLong(line.replaceAll("\\D+", "")) << 10;
      }
    }
    return 0;
  }

  private static void print(Plan plan, Figures console, Figures echo) {
    System.out.printf(
        Locale.ROOT,
        "%d idle and %d busy clients, %d connect at once%n%-42s %12s %12s %8s%n",
        plan.idle,
        plan.busy,
        plan.burst,
        "",
        "console",
        "bare echo",
        "ratio");
    row("connect to first answer, median, ms", console, echo, f -> at(f.connects, 0.5));
    row("connect to first answer, 99 %, ms", console, echo, f -> at(f.connects, 0.99));
    row("connect to first answer, slowest, ms", console, echo, f -> at(f.connects, 1));
    row("live objects of a client, kB", console, echo, f -> f.live / 1e3);
    row("memory of the process for a client, kB", console, echo, f -> f.resident / 1e3);
    row("answers in a second", console, echo, f -> f.busy.times().length / f.busy.seconds());
    row("answer, median, ms", console, echo, f -> at(f.busy.times(), 0.5));
    row("answer, 99 %, ms", console, echo, f -> at(f.busy.times(), 0.99));
    row("answer, slowest, ms", console, echo, f -> at(f.busy.times(), 1));
    row("answers of the client with fewest", console, echo, f -> f.busy.answers()[0]);
    row("answers of the client with most", console, echo, f -> last(f.busy.answers()));
  }

  private static double last(int[] sorted) {
    return sorted[sorted.length - 1];
  }

  private static double at(long[] sorted, double share) {
    return sorted[(int) (share * (sorted.length - 1))] / 1e6;
  }

  private static void row(
      String name, Figures console, Figures echo, ToDoubleFunction<Figures> figure) {
    double own = figure.applyAsDouble(console);
    double other = figure.applyAsDouble(echo);
    System.out.printf(
        Locale.ROOT,
        "%-42s %,12.2f %,12.2f %8.2f%n",
        name,
        own,
        other,
        other == 0 ? Double.NaN : own / other);
  }
}

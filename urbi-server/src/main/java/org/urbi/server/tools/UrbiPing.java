package org.urbi.server.tools;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.io.PrintStream;
import java.io.Writer;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.SystemClock;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;
import urbi.ServerConnection;

/**
 * The program {@code urbi-ping}: measures how long a server takes to execute a statement and to
 * answer (manual, section 21.7).
 */
public final class UrbiPing {
  private static final int DEFAULT_INTERVAL = 1000;
  private static final int TIMEOUT_MILLISECONDS = 10_000;
  private static final Pattern PONG = Pattern.compile("\\[\\d+:ping\\] (\\d+)\\s*");

  private final PrintStream out;
  private final Clock clock = new SystemClock();
  private final DelayStatistics delayStatistics = new DelayStatistics();

  private UrbiPing(PrintStream out) {
    this.out = out;
  }

  public static void main(String[] args) {
    System.exit(run(args, System.out, System.err));
  }

  /** Runs the program and returns its exit status: 0 if the server has ever answered. */
  public static int run(String[] args, PrintStream out, PrintStream err) {
    Program program =
        new Program("urbi-ping", "Measures how long a running Urbi server takes to answer.");
    return ServerAddress.options(program)
        .option("COUNT", "How many pings to send; 0, the default: no limit.", "-c", "--count")
        .option(
            "INTERVAL",
            "Milliseconds from one ping to the next (default: 1000); 0 floods the connection.",
            "-i",
            "--interval")
        .arguments("[HOST] [INTERVAL] [COUNT]", "Same as the options of these names.")
        .run(args, out, err, new UrbiPing(out)::ping);
  }

  private int ping(Arguments arguments) {
    List<String> rest = arguments.rest();
    if (rest.size() > 3) {
      throw Failure.usage("too many arguments: " + String.join(" ", rest.subList(3, rest.size())));
    }
    ServerAddress target =
        ServerAddress.of(
            arguments, arguments.value("--host", rest.isEmpty() ? "127.0.0.1" : rest.get(0)));
    int interval = number(arguments, "--interval", rest, 1, DEFAULT_INTERVAL);
    int count = number(arguments, "--count", rest, 2, 0);
    Thread summary =
        FailureLog.THREADS.platform("urbi-ping-summary", () -> out.println(delayStatistics));
    try (ServerConnection server = target.connect()) {
      Runtime.getRuntime().addShutdownHook(summary);
      server.setReadTimeout(TIMEOUT_MILLISECONDS);
      out.println("Pinging " + target);
      exchange(server, interval, count);
    } catch (IOException e) {
      throw Failure.of("connection lost: " + e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      if (Runtime.getRuntime().removeShutdownHook(summary)) {
        out.println(delayStatistics);
      }
    }
    return delayStatistics.received() > 0 ? 0 : 1;
  }

  private static int number(
      Arguments arguments, String option, List<String> rest, int place, int otherwise) {
    int fallback =
        rest.size() > place
            ? Arguments.number(option.substring(2), rest.get(place), 0, Integer.MAX_VALUE)
            : otherwise;
    return arguments.number(option, fallback, 0, Integer.MAX_VALUE);
  }

  private void exchange(ServerConnection server, int interval, int count)
      throws IOException, InterruptedException {
    BufferedReader in =
        new BufferedReader(new InputStreamReader(server.in(), StandardCharsets.ISO_8859_1));
    Writer to = new OutputStreamWriter(server.out(), StandardCharsets.US_ASCII);
    for (int i = 1; count == 0 || i <= count; ++i) {
      long start = clock.now();
      to.write("lobby.send(\"" + i + "\", \"ping\");\n");
      to.flush();
      delayStatistics.sent();
      if (awaitPong(in, i)) {
        long delay = clock.now() - start;
        delayStatistics.add(delay);
        if (interval > 0) {
          out.println(i + ": " + DelayStatistics.milliseconds(delay));
        }
      } else {
        out.println(i + ": no answer");
      }
      long left = TimeUnit.MILLISECONDS.toNanos(interval) - (clock.now() - start);
      if (left > 0 && (count == 0 || i < count)) {
        TimeUnit.NANOSECONDS.sleep(left);
      }
    }
  }

  private static boolean awaitPong(BufferedReader in, int number) throws IOException {
    try {
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        Matcher pong = PONG.matcher(line);
        if (pong.matches() && pong.group(1).equals(String.valueOf(number))) {
          return true;
        }
      }
    } catch (SocketTimeoutException e) {
      return false;
    }
    throw new IOException("the server hung up");
  }
}

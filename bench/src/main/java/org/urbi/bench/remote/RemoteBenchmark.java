package org.urbi.bench.remote;

import static java.util.Objects.requireNonNull;

import java.io.BufferedReader;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import org.urbi.kernel.Kernel;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;

/**
 * Calls of a function in another process beside a bare echo of as many bytes there; updates of a
 * variable from there; images to there. All in one run, turn by turn.
 */
public final class RemoteBenchmark {
  /** What a call and its result have on the wire. */
  private static final int CALL_BYTES = 44;

  private static final int WARM_UP = 8;
  private static final int ROUNDS = 20;
  private static final int CALLS = 5_000;
  private static final int UPDATES = 300_000;
  private static final int IMAGES = 600;

  private final long[] marks = new long[CALLS + 1];
  private int marked;

  private RemoteBenchmark() {}

  /** Runs all, and prints a table. */
  public static void main(String[] arguments) throws IOException {
    new RemoteBenchmark().run();
  }

  private void run() throws IOException {
    try (Kernel kernel = Kernel.builder().start();
        ConsoleServer server =
            new ConsoleServer(
                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                client -> kernel.connect(client, false),
                kernel::connectRemote,
                Limits.DEFAULT,
                new Trace(Trace.Level.NONE, System.err))) {
      Process component = component(server.port());
      try {
        var said =
            new BufferedReader(
                new InputStreamReader(component.getInputStream(), StandardCharsets.UTF_8));
        measure(kernel, Integer.parseInt(said.readLine()));
      } finally {
        component.destroy();
      }
    }
  }

  private static Process component(int port) throws IOException {
    return new ProcessBuilder(
            System.getProperty("java.home") + "/bin/java",
            "-cp",
            System.getProperty("java.class.path"),
            ComponentProcess.class.getName(),
            String.valueOf(port))
        .redirectError(ProcessBuilder.Redirect.INHERIT)
        .start();
  }

  private void measure(Kernel kernel, int echoPort) throws IOException {
    kernel.define(
        "mark",
        ignored -> {
          marks[marked++] = System.nanoTime();
          return null;
        });
    long[] calls = new long[ROUNDS * CALLS];
    long[] echoes = new long[ROUNDS * CALLS];
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), echoPort)) {
      socket.setTcpNoDelay(true);
      for (int round = -WARM_UP; round < ROUNDS; round++) {
        marked = 0;
        kernel.eval(
            "for| (var i = 0; i < " + CALLS + "; i += 1) { mark() | Component.echo(i) } | mark()");
        if (round >= 0) {
          differences(calls, round * CALLS);
        }
        echo(socket);
        if (round >= 0) {
          differences(echoes, round * CALLS);
        }
      }
    }
    row("call of a remote function", calls, echoes, 0.5, 2);
    row("the same, 99th percentile", calls, echoes, 0.99, 5);
    updates(kernel);
    images(kernel);
  }

  private void differences(long[] into, int at) {
    for (int i = 0; i < CALLS; i++) {
      into[at + i] = marks[i + 1] - marks[i];
    }
  }

  private void echo(Socket socket) throws IOException {
    byte[] bytes = new byte[CALL_BYTES];
    var in = new DataInputStream(socket.getInputStream());
    marks[0] = System.nanoTime();
    for (int i = 1; i <= CALLS; i++) {
      socket.getOutputStream().write(bytes);
      in.readFully(bytes);
      marks[i] = System.nanoTime();
    }
  }

  private static void row(String name, long[] calls, long[] echoes, double share, double target) {
    double call = percentile(calls, share);
    double echo = percentile(echoes, share);
    System.out.printf(
        Locale.ROOT,
        "%-28s %8.1f us   bare echo %8.1f us   ratio %5.2f   target %.0f  %s%n",
        name,
        call / 1000,
        echo / 1000,
        call / echo,
        target,
        call / echo <= target ? "met" : "MISSED");
  }

  private static double percentile(long[] values, double share) {
    long[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[(int) (share * (sorted.length - 1))];
  }

  private static void updates(Kernel kernel) {
    String code =
        "{ Component.flood(" + UPDATES + ") | while (Component.v != " + UPDATES + ") sleep(1ms) }";
    kernel.eval(code);
    kernel.eval("Component.v = 0");
    long start = System.nanoTime();
    kernel.eval(code);
    rate("updates from a remote", UPDATES, start, 100_000);
  }

  private static void images(Kernel kernel) {
    kernel.eval(
        "var Global.image = 0 | var Global.data = Binary.new(\"rgb 640 480\", \"x\" * 921600) |"
            + " Component.watch(\"Global.image\")");
    for (int turn = 0; turn < 2; turn++) {
      kernel.eval("Component.count");
      long start = System.nanoTime();
      kernel.eval(
          "for| (var i = 0; i < "
              + IMAGES
              + "; i += 1) { Global.image = Global.data | sleep(1ms) }");
      int seen = requireNonNull(kernel.eval("Component.count", Integer.class), "a count");
      if (turn == 1) {
        rate("640x480 images to a remote", seen, start, 200);
      }
    }
  }

  private static void rate(String what, int count, long start, double target) {
    double rate = count / ((System.nanoTime() - start) / 1e9);
    System.out.printf(
        Locale.ROOT,
        "%-28s %,10.0f / s   target %,.0f / s  %s%n",
        what,
        rate,
        target,
        rate >= target ? "met" : "MISSED");
  }
}

package org.urbi.bench.remote;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;
import org.urbi.server.tools.UrbiCertificate;
import org.urbi.server.trust.AccessPolicy;
import org.urbi.server.trust.ServerIdentity;
import urbi.ServerConnection;

/**
 * The way of a statement to a server and of its answer back, and connecting with a first statement,
 * by each kind of connection. All in one run, turn by turn.
 */
public final class ConnectionBenchmark {
  private static final int WARM_UP = 5;
  private static final int ROUNDS = 10;
  private static final int STATEMENTS = 1_000;
  private static final int CONNECTS = 50;
  private static final int MILLISECONDS = 10_000;

  /** A kind of connection, and what was measured of it. */
  private static final class Kind {
    private final String name;
    private final String host;
    private final int port;
    private final boolean tls;
    private final long[] answers = new long[ROUNDS * STATEMENTS];
    private final long[] connects = new long[ROUNDS * CONNECTS];

    Kind(String name, String host, int port, boolean tls) {
      this.name = name;
      this.host = host;
      this.port = port;
      this.tls = tls;
    }
  }

  private ConnectionBenchmark() {}

  /** Runs all, and prints a table. */
  public static void main(String[] arguments) throws IOException {
    Path folder = Files.createTempDirectory("urbi-bench");
    Path identity = folder.resolve("own");
    PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream());
    UrbiCertificate.run(new String[] {identity.toString(), "localhost"}, nowhere, System.err);
    Path socket = folder.resolve("console");
    try (Kernel kernel = Kernel.builder().start();
        ConsoleServer plain = listen(kernel, null);
        ConsoleServer secure =
            listen(
                kernel,
                ServerIdentity.read(Path.of(identity + ".crt"), Path.of(identity + ".key")))) {
      plain.listen(socket, PosixFilePermissions.fromString("rw-------"));
      measure(
          List.of(
              new Kind("TCP", "localhost", plain.port(), false),
              new Kind("Unix domain socket", socket.toString(), 0, false),
              new Kind("TLS", "localhost", secure.port(), true)),
          identity + ".crt");
    } finally {
      Files.delete(Path.of(identity + ".crt"));
      Files.delete(Path.of(identity + ".key"));
      Files.delete(folder);
    }
  }

  private static ConsoleServer listen(Kernel kernel, @Nullable ServerIdentity identity)
      throws IOException {
    return new ConsoleServer(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
        client -> kernel.connect(client, false),
        kernel::connectRemote,
        Limits.DEFAULT,
        new AccessPolicy(null, Role.OWNER, identity),
        new Trace(Trace.Level.NONE, System.err));
  }

  private static void measure(List<Kind> kinds, String certificate) throws IOException {
    for (int round = -WARM_UP; round < ROUNDS; round++) {
      for (Kind each : kinds) {
        if (each.tls) {
          ServerConnection.trust(certificate);
        } else {
          System.setProperty(ServerConnection.TLS_PROPERTY, "no");
        }
        statements(each, Math.max(0, round) * STATEMENTS);
        connects(each, Math.max(0, round) * CONNECTS);
      }
    }
    for (Kind each : kinds) {
      row(each.name, "statement and answer", each.answers, kinds.getFirst().answers);
    }
    for (Kind each : kinds) {
      row(each.name, "connecting, and one", each.connects, kinds.getFirst().connects);
    }
  }

  private static void statements(Kind kind, int at) throws IOException {
    try (ServerConnection connection = connect(kind)) {
      BufferedReader in = reader(connection);
      for (int i = 0; i < STATEMENTS; i++) {
        long start = System.nanoTime();
        ask(connection, in);
        kind.answers[at + i] = System.nanoTime() - start;
      }
    }
  }

  private static void connects(Kind kind, int at) throws IOException {
    for (int i = 0; i < CONNECTS; i++) {
      long start = System.nanoTime();
      try (ServerConnection connection = connect(kind)) {
        ask(connection, reader(connection));
        kind.connects[at + i] = System.nanoTime() - start;
      }
    }
  }

  private static ServerConnection connect(Kind kind) throws IOException {
    return ServerConnection.open(kind.host, kind.port, MILLISECONDS);
  }

  private static BufferedReader reader(ServerConnection connection) {
    return new BufferedReader(new InputStreamReader(connection.in(), StandardCharsets.US_ASCII));
  }

  private static void ask(ServerConnection connection, BufferedReader in) throws IOException {
    connection.out().write("1;\n".getBytes(StandardCharsets.US_ASCII));
    String line = in.readLine();
    if (line == null || !line.endsWith(" 1")) {
      throw new IOException("unexpected answer: " + line);
    }
  }

  private static void row(String name, String what, long[] values, long[] beside) {
    System.out.printf(
        Locale.ROOT,
        "%-22s %-20s %8.0f us   99th percentile %8.0f us   median beside TCP %5.2f%n",
        name,
        what,
        percentile(values, 0.5) / 1000,
        percentile(values, 0.99) / 1000,
        percentile(values, 0.5) / percentile(beside, 0.5));
  }

  private static double percentile(long[] values, double share) {
    long[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[(int) (share * (sorted.length - 1))];
  }
}

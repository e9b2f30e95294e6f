package org.urbi.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * With which power of n the time grows for n of something. Each size does the same work in all, by
 * being repeated, so that neither warm-up nor garbage favours one of them.
 */
final class Growth {
  private static final String NAME = "growth";
  private static final int FACTOR = 4;
  private static final int SIZES = 4;
  private static final double MOST = 1.1;

  private final Installation machine;
  private final int rounds;

  /** What grows, and its largest size. */
  private record Kind(String name, String title, int largest) {}

  private static final List<Kind> KINDS =
      List.of(
          new Kind("slots", "slots of an object", 64_000),
          new Kind("handlers", "handlers of an event", 6_400),
          new Kind("ats", "ats on a slot", 6_400),
          new Kind("jobs", "jobs", 64_000),
          new Kind("list", "elements of a list", 640_000));

  private static final Kind CLIENTS = new Kind("clients", "clients that connect and ask", 1_600);

  /** Does the work for one size so many times. */
  private interface Work {
    void run(int size, int times) throws IOException, LanguageProcess.Failure;
  }

  Growth(Installation machine, int rounds) {
    this.machine = machine;
    this.rounds = rounds;
  }

  /** A row for each kind. */
  List<Result> run() {
    List<Result> results = new ArrayList<>();
    for (Kind kind : KINDS) {
      try (LanguageProcess process =
          LanguageProcess.start(machine, Language.URBISCRIPT, NAME, "").orElseThrow()) {
        results.add(
            measure(
                kind,
                (size, times) -> {
                  String answer =
                      process.evaluate("repeat(&%s, %d, %d);".formatted(kind.name, size, times));
                  if (!answer.equals(Integer.toString(size * times))) {
                    throw new LanguageProcess.Failure(answer + " instead of " + size * times);
                  }
                }));
      } catch (IOException | LanguageProcess.Failure e) {
        results.add(Result.failed(NAME, kind.title, String.valueOf(e.getMessage())));
      }
    }
    results.add(clients());
    return results;
  }

  private Result clients() {
    try {
      Path portFile = Files.createTempDirectory("urbi-growth").resolve("port");
      String[] server = {"-P", "0", "-w", portFile.toString()};
      try (LanguageProcess process =
          LanguageProcess.start(machine, Language.URBISCRIPT, NAME, "", server).orElseThrow()) {
        process.evaluate("42;");
        int port = Integer.parseInt(Files.readString(portFile).strip());
        return measure(
            CLIENTS,
            (size, times) -> {
              for (int turn = 0; turn < times; turn++) {
                connectAndAsk(port, size);
              }
            });
      }
    } catch (IOException | LanguageProcess.Failure e) {
      return Result.failed(NAME, CLIENTS.title, String.valueOf(e.getMessage()));
    }
  }

  private static void connectAndAsk(int port, int clients) throws IOException {
    List<Socket> sockets = new ArrayList<>();
    try {
      for (int i = 0; i < clients; i++) {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        sockets.add(socket);
        socket.setTcpNoDelay(true);
        socket.getOutputStream().write("1|echo(42);\n".getBytes(StandardCharsets.ISO_8859_1));
      }
      for (Socket socket : sockets) {
        var reader =
            new BufferedReader(
                new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
        String line = reader.readLine();
        while (line != null && !line.endsWith("*** 42")) {
          line = reader.readLine();
        }
        if (line == null) {
          throw new IOException("the server has hung up");
        }
      }
    } finally {
      for (Socket socket : sockets) {
        socket.close();
      }
    }
  }

  private Result measure(Kind kind, Work work) throws IOException, LanguageProcess.Failure {
    double[] sizes = new double[SIZES];
    double[] best = new double[SIZES];
    for (int round = 0; round <= rounds; round++) {
      for (int i = 0; i < SIZES; i++) {
        int size = kind.largest / (int) Math.pow(FACTOR, SIZES - 1.0 - i);
        long start = System.nanoTime();
        work.run(size, kind.largest / size);
        double taken = System.nanoTime() - start;
        sizes[i] = size;
        // The first round warms up.
        best[i] = round <= 1 ? taken : Math.min(best[i], taken);
      }
    }
    return new Result(
        NAME,
        kind.title,
        Unit.EXPONENT,
        Map.of(Language.URBISCRIPT, 1 + slope(sizes, best)),
        Map.of(),
        new Target.Absolute(MOST, Unit.EXPONENT),
        "");
  }

  /** The slope of the straight line nearest to the logarithms. */
  static double slope(double[] x, double[] y) {
    double meanX = 0;
    double meanY = 0;
    for (int i = 0; i < x.length; i++) {
      meanX += Math.log(x[i]) / x.length;
      meanY += Math.log(y[i]) / x.length;
    }
    double above = 0;
    double below = 0;
    for (int i = 0; i < x.length; i++) {
      above += (Math.log(x[i]) - meanX) * (Math.log(y[i]) - meanY);
      below += (Math.log(x[i]) - meanX) * (Math.log(x[i]) - meanX);
    }
    return above / below;
  }
}

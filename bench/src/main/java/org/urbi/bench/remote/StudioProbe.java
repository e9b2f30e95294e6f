package org.urbi.bench.remote;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * A server with 10,000 jobs, 1,000 reactions, 1,000 slots and, when it is asked for, a loop with a
 * period of 10 ms that notes when each turn begins.
 */
final class StudioProbe implements AutoCloseable {
  private static final String BEGUN = "begun: ";

  private static final String PROGRAM =
      "var Global.begun = []|; var Global.begin = System.time|; var Global.turn = 0|;"
          + "many: for& (10000) sleep(1h),"
          + "var Global.never = 0|; for (1000) at (never == 1) 1;"
          + "var Global.o = Object.new|; for (var i : 1000) o.setSlot(\"x\" + i, i);"
          + "var Global.sound = Binary.new(\"wav\", \"x\" * 4000000)|;"
          + "probe: {}; echo(\"ready\");";

  private static final String BEGIN =
      "begun = [] | begin = System.time | turn = 0 |"
          + "probe: every| (10ms) { begun << (System.time - begin) | turn++ },";

  private static final String END =
      "probe.stop; echo(\""
          + BEGUN
          + "\" + begun.map(function (moment) { \"%.9f\" % moment }).join(\" \"));";

  private final Process server;
  private final BufferedReader said;
  private final PrintStream input;

  /**
   * Starts it.
   *
   * @param options of the command, besides the program
   */
  StudioProbe(Path root, String... options) throws IOException {
    List<String> command =
        new ArrayList<>(List.of(root.resolve("urbi").toString(), "-q", "-i", "-e", PROGRAM));
    command.addAll(List.of(options));
    server = new ProcessBuilder(command).redirectErrorStream(true).start();
    said =
        new BufferedReader(new InputStreamReader(server.getInputStream(), StandardCharsets.UTF_8));
    input = new PrintStream(server.getOutputStream(), true, StandardCharsets.UTF_8);
  }

  /** The first line with a text that it says from now on. */
  String await(String part) throws IOException {
    for (String line = said.readLine(); line != null; line = said.readLine()) {
      if (line.contains(part)) {
        return line;
      }
    }
    throw new IOException("the server has ended");
  }

  /** Has it run some code. */
  void say(String code) {
    input.println(code);
  }

  void begin() {
    input.println(BEGIN);
  }

  /** When each period since the beginning began, in nanoseconds. */
  double[] end() throws IOException {
    input.println(END);
    String moments = await(BEGUN).replaceFirst(".*" + BEGUN, "");
    return Stream.of(moments.split(" "))
        .mapToDouble(each -> 1e9 * Double.parseDouble(each))
        .toArray();
  }

  Duration processorTime() {
    return server.toHandle().info().totalCpuDuration().orElse(Duration.ZERO);
  }

  @Override
  public void close() {
    server.destroy();
    server.onExit().join();
  }
}

package org.urbi.bench.remote;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A server with 10,000 jobs, 1,000 reactions, 1,000 slots and, when it is asked for, a loop with a
 * period of 10 ms that notes how late it is.
 */
final class StudioProbe implements AutoCloseable {
  /** The period of the loop, in milliseconds. */
  static final int PERIOD = 10;

  private static final String PROGRAM =
      "var Global.late = []|; var Global.begin = System.time|; var Global.turn = 0|;"
          + "many: for& (10000) sleep(1h),"
          + "var Global.never = 0|; for (1000) at (never == 1) 1;"
          + "var Global.o = Object.new|; for (var i : 1000) o.setSlot(\"x\" + i, i);"
          + "var Global.sound = Binary.new(\"wav\", \"x\" * 4000000)|;"
          + "probe: {}; echo(\"ready\");";

  private static final String BEGIN =
      "late = [] | begin = System.time | turn = 0 |"
          + "probe: every| (10ms) { late << (System.time - begin - 0.01 * turn) | turn++ },";

  private static final String END = "probe.stop; echo(\"late \" + late);";

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

  void begin() {
    input.println(BEGIN);
  }

  /** How late each period was since the beginning, in milliseconds. */
  double[] end() throws IOException {
    input.println(END);
    String list = await("late [").replaceFirst(".*\\[", "").replace("]", "");
    return Arrays.stream(list.split(", "))
        .mapToDouble(each -> 1000 * Double.parseDouble(each))
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

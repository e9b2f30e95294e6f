package org.urbi.bench.remote;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;

/**
 * A server with 10,000 jobs, 1,000 reactions, 1,000 slots and a loop with a period of 10 ms, in
 * turns without a page of the studio and with one in each of its rooms: processor time of the
 * server, and how late the loop is.
 */
public final class StudioBenchmark {
  private static final int ROUNDS = 3;
  private static final int SECONDS = 10;

  /** What a page sends that is in a room; of the code, one that is typing all the time. */
  private enum Room {
    NOBODY(""),
    JOBS("{\"type\":\"interest\",\"selected\":0,\"traced\":[]}"),
    REACTIONS("{\"type\":\"reactions\",\"filter\":\"\"}"),
    VARIABLES("{\"type\":\"variables\",\"objects\":[\"Global\",\"Global\\n.o\"]}"),
    PLOT("{\"type\":\"plot\",\"id\":1,\"ways\":[\"Global\\n.turn\",\"Global\\n.begin\"]}"),
    CODE("{\"type\":\"complete\",\"id\":1,\"text\":\"System.\"}");

    private final String request;

    Room(String request) {
      this.request = request;
    }

    String title() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  private static final String PROGRAM =
      "var Global.late = []|; var Global.begin = System.time|; var Global.turn = 0|;"
          + "many: for& (10000) sleep(1h),"
          + "var Global.never = 0|; for (1000) at (never == 1) 1;"
          + "var Global.o = Object.new|; for (var i : 1000) o.setSlot(\"x\" + i, i);"
          + "probe: every| (10ms) { late << (System.time - begin - 0.01 * turn) | turn++ },";

  /** Starts to measure anew, when all jobs have been started. */
  private static final String AGAIN =
      "probe.stop; late = [] | begin = System.time | turn = 0 |"
          + "probe: every| (10ms) { late << (System.time - begin - 0.01 * turn) | turn++ },";

  private static final String ASK =
      "{ var s = late.sort()| echo(\"late \" + s[(s.size * 0.999).floor] + \" \" + s[s.size - 1]) };";

  private final Process server;
  private final BufferedReader said;
  private final PrintStream input;
  private final String address;

  private StudioBenchmark(Path root) throws IOException {
    server =
        new ProcessBuilder(root.resolve("urbi").toString(), "-q", "-i", "--studio=0", "-e", PROGRAM)
            .redirectErrorStream(true)
            .start();
    said =
        new BufferedReader(new InputStreamReader(server.getInputStream(), StandardCharsets.UTF_8));
    input = new PrintStream(server.getOutputStream(), true, StandardCharsets.UTF_8);
    String line = await("studio: ");
    address = line.substring(line.indexOf("http://") + "http://".length()).strip();
  }

  private String await(String part) throws IOException {
    for (String line = said.readLine(); line != null; line = said.readLine()) {
      if (line.contains(part)) {
        return line;
      }
    }
    throw new IOException("the server has ended");
  }

  /** A page that reads all that it is sent. */
  private static final class Page implements WebSocket.Listener {
    private long bytes;

    @Override
    public @Nullable CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
      bytes += data.length();
      from.request(1);
      return null;
    }
  }

  private void measure(Room room) throws Exception {
    Page page = new Page();
    WebSocket socket = null;
    if (room != Room.NOBODY) {
      URI stream = URI.create("ws://" + address + "stream");
      socket = HttpClient.newHttpClient().newWebSocketBuilder().buildAsync(stream, page).join();
      socket.sendText(room.request, true).join();
    }
    // What is told first, and compiled first, is not what it costs to look.
    Thread.sleep(Duration.ofSeconds(5));
    input.println(AGAIN);
    Duration before = processorTime();
    long bytes = page.bytes;
    for (int second = 0; second < SECONDS; second++) {
      Thread.sleep(Duration.ofSeconds(1));
      if (socket != null && room == Room.CODE) {
        socket.sendText(room.request, true).join();
      }
    }
    Duration used = processorTime().minus(before);
    bytes = page.bytes - bytes;
    input.println(ASK);
    String[] late = await("late ").split(" ");
    System.out.printf(
        Locale.ROOT,
        "%-10s %5.2f %% of a core, p99.9 %6.3f ms late, worst %6.3f ms, %6.1f kB/s%n",
        room.title(),
        used.toNanos() / 1e7 / SECONDS,
        1000 * Double.parseDouble(late[late.length - 2]),
        1000 * Double.parseDouble(late[late.length - 1]),
        bytes / 1000.0 / SECONDS);
    if (socket != null) {
      socket.abort();
    }
  }

  private Duration processorTime() {
    return server.toHandle().info().totalCpuDuration().orElse(Duration.ZERO);
  }

  public static void main(String[] arguments) throws Exception {
    StudioBenchmark bench = new StudioBenchmark(Path.of(System.getProperty("bench.root")));
    try {
      Thread.sleep(Duration.ofSeconds(10));
      for (int round = 0; round < ROUNDS; round++) {
        for (Room room : Room.values()) {
          bench.measure(room);
        }
      }
    } finally {
      bench.server.destroy();
      bench.server.waitFor();
    }
  }
}

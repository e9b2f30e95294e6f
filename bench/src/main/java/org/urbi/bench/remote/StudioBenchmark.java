package org.urbi.bench.remote;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.DoubleStream;
import org.jspecify.annotations.Nullable;
import org.urbi.bench.Lateness;
import org.urbi.bench.Load;

/**
 * What it costs a server that somebody looks, and whether that is what was promised: processor time
 * in each room of the studio, and how late a loop of 10 ms is, in turns with a page and without,
 * also with one that does not read. Then how long a browser takes until it shows something, and
 * whether it stays smooth.
 */
public final class StudioBenchmark {
  /** Enough for 2,000 periods in each room: p99.9 is the third latest. */
  private static final int ROUNDS = 3;

  private static final int SECONDS = 7;

  /** What is told first, and compiled first, is not what it costs to look. */
  private static final Duration SETTLING = Duration.ofSeconds(2);

  /**
   * How much the system keeps for a page that does not read, in bytes. By itself it takes up to
   * tens of megabytes: views that wait there have left the server.
   */
  private static final int RECEIVED = 1 << 16;

  /** What a viewer may cost besides, in percent of a core. */
  private static final double MOST_FOR_A_VIEWER = 2;

  /** What cannot be told from nothing, likewise. */
  private static final double MOST_FOR_NOBODY = 0.3;

  /** How much later 99.9 % of all periods may begin, in milliseconds. */
  private static final double MOST_LATER = 1;

  /** Where 99.9 % of all periods begin later without any studio, that cannot be told. */
  private static final double MOST_ALONE = 5;

  /** How many views may have been kept for a page that has not read. */
  private static final int MOST_KEPT = 5;

  /** How long one that has begun to read is listened to: a few views are made then. */
  private static final Duration AFTERWARDS = Duration.ofSeconds(2);

  private static final double MILLISECOND = 1e6;

  private static final String INTEREST = "{\"type\":\"interest\",\"selected\":0,\"traced\":[]}";

  private static final String SOUND = "{\"type\":\"show\",\"id\":1,\"way\":\"Global\\n.sound\"}";

  /** What a page sends that is in a room; of the code, one that is typing all the time. */
  private enum Room {
    UNSERVED("no studio"),
    NOBODY("nobody"),
    JOBS("jobs", INTEREST),
    REACTIONS("reactions", "{\"type\":\"reactions\",\"filter\":\"\"}"),
    VARIABLES("variables", "{\"type\":\"variables\",\"objects\":[\"Global\",\"Global\\n.o\"]}"),
    PLOT("plot", "{\"type\":\"plot\",\"id\":1,\"ways\":[\"Global\\n.turn\",\"Global\\n.begin\"]}"),
    CODE("code", "{\"type\":\"complete\",\"id\":1,\"text\":\"System.\"}"),
    // What is too much for all buffers on the way: while it comes, the page stops reading.
    DEAF("does not read", INTEREST, SOUND);

    private final String title;
    private final List<String> requests;

    Room(String title, String... requests) {
      this.title = title;
      this.requests = List.of(requests);
    }
  }

  /** What was measured in a room: a value for each of its turns, and how late each period was. */
  private static final class Result {
    private final List<Double> processor = new ArrayList<>();
    private final List<Double> kilobytes = new ArrayList<>();
    private final List<Double> views = new ArrayList<>();
    private double[] late = new double[0];

    void add(double[] periods) {
      int known = late.length;
      late = Arrays.copyOf(late, known + periods.length);
      System.arraycopy(periods, 0, late, known, periods.length);
    }

    /** What all periods but one in a thousand are not later than, in milliseconds. */
    double mostly() {
      double[] sorted = late.clone();
      Arrays.sort(sorted);
      return Lateness.at(sorted, 0.999);
    }

    double worst() {
      return Arrays.stream(late).max().orElse(0);
    }

    double processor() {
      return median(processor);
    }

    private static double median(List<Double> all) {
      List<Double> sorted = all.stream().sorted().toList();
      return (sorted.get((sorted.size() - 1) / 2) + sorted.get(sorted.size() / 2)) / 2;
    }
  }

  /** A page that reads all that it is sent; one that is deaf only until a sound comes. */
  private static final class Page implements WebSocket.Listener {
    private static final String VIEW = "{\"type\":\"view\",\"machine\":";

    private final boolean deaf;
    private final AtomicLong bytes = new AtomicLong();
    private final AtomicLong views = new AtomicLong();
    private final List<View> later = new ArrayList<>();
    private final CompletableFuture<@Nullable Void> stopped = new CompletableFuture<>();
    private boolean within;

    /** A view: when it was made, of the server's time, and when it came; in milliseconds. */
    private record View(double made, double came) {}

    Page(boolean deaf) {
      this.deaf = deaf;
    }

    @Override
    public void onOpen(WebSocket from) {
      from.request(deaf ? 1 : Long.MAX_VALUE);
    }

    @Override
    public @Nullable CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
      bytes.addAndGet(data.length());
      String text = within ? "" : data.toString();
      within = !last;
      if (text.startsWith(VIEW)) {
        views.incrementAndGet();
        if (stopped.isDone()) {
          double made =
              Double.parseDouble(text.substring(VIEW.length(), text.indexOf(',', VIEW.length())));
          later.add(new View(made, System.nanoTime() / MILLISECOND));
        }
      }
      if (deaf && !stopped.isDone()) {
        if (text.startsWith("{\"type\":\"done\"")) {
          stopped.complete(null);
        } else {
          from.request(1);
        }
      }
      return null;
    }

    /**
     * Begins to read again, and returns how many views there are that had been made before. The one
     * that has come soonest tells how the clocks differ.
     */
    int readAgain(WebSocket from) throws InterruptedException {
      double begin = System.nanoTime() / MILLISECOND;
      from.request(Long.MAX_VALUE);
      Thread.sleep(AFTERWARDS);
      double apart = later.stream().mapToDouble(view -> view.came - view.made).min().orElse(0);
      return (int) later.stream().filter(view -> view.made + apart < begin).count();
    }
  }

  private final Map<Room, Result> results = new EnumMap<>(Room.class);
  private final StudioProbe unserved;
  private final StudioProbe served;
  private final URI stream;

  private StudioBenchmark(StudioProbe unserved, StudioProbe served) throws IOException {
    this.unserved = unserved;
    this.served = served;
    String line = served.await("studio: http://");
    stream = URI.create("ws" + line.substring(line.indexOf("://")).strip() + "stream");
    served.await("ready");
    unserved.await("ready");
  }

  private Result result(Room room) {
    return results.computeIfAbsent(room, unmeasured -> new Result());
  }

  /** Measures each room once. */
  private void round() throws Exception {
    for (Room room : Room.values()) {
      measure(room);
    }
  }

  private void measure(Room room) throws Exception {
    if (room.requests.isEmpty()) {
      measure(room, new Page(true), null);
      return;
    }
    Page page = new Page(room == Room.DEAF);
    try (HttpClient client = HttpClient.newHttpClient()) {
      WebSocket socket = client.newWebSocketBuilder().buildAsync(stream, page).join();
      for (String request : room.requests) {
        socket.sendText(request, true).join();
      }
      measure(room, page, socket);
      socket.abort();
    }
  }

  private void measure(Room room, Page page, @Nullable WebSocket socket) throws Exception {
    StudioProbe server = room == Room.UNSERVED ? unserved : served;
    if (room == Room.DEAF) {
      page.stopped.join();
    }
    server.begin();
    Thread.sleep(SETTLING);
    Duration before = server.processorTime();
    long bytes = page.bytes.get();
    long views = page.views.get();
    for (int second = 0; second < SECONDS; second++) {
      Thread.sleep(Duration.ofSeconds(1));
      if (socket != null && room == Room.CODE) {
        socket.sendText(room.requests.getFirst(), true).join();
      }
    }
    Result result = result(room);
    result.processor.add(server.processorTime().minus(before).toNanos() / 1e7 / SECONDS);
    result.kilobytes.add((page.bytes.get() - bytes) / 1000.0 / SECONDS);
    result.views.add((double) (page.views.get() - views) / SECONDS);
    // The first ones are those while it settles.
    DoubleStream begun = Arrays.stream(server.end()).skip(SETTLING.toNanos() / Lateness.PERIOD);
    result.add(Arrays.stream(Lateness.late(begun)).map(each -> each / MILLISECOND).toArray());
    if (socket != null && room == Room.DEAF) {
      result.views.set(result.views.size() - 1, (double) page.readAgain(socket));
    }
  }

  // ------------------------------------------------------------------ what comes of it

  /** Whether a millisecond can be told: the loop is hardly ever late by itself. */
  private boolean isCalm() {
    return result(Room.UNSERVED).mostly() <= MOST_ALONE;
  }

  /** What was promised for a room and is missed; empty if nothing is. */
  private String missed(Room room) {
    Result result = result(room);
    Result without = result(room == Room.NOBODY ? Room.UNSERVED : Room.NOBODY);
    double most = without.processor() + (room == Room.NOBODY ? MOST_FOR_NOBODY : MOST_FOR_A_VIEWER);
    List<String> missed = new ArrayList<>();
    if (result.processor() > most) {
      missed.add("at most %.2f %% of a core".formatted(most));
    }
    if (isCalm() && result.mostly() > without.mostly() + MOST_LATER) {
      missed.add("p99.9 at most %.3f ms".formatted(without.mostly() + MOST_LATER));
    }
    if (room == Room.DEAF && Result.median(result.views) > MOST_KEPT) {
      missed.add("at most " + MOST_KEPT + " views");
    }
    return String.join(", ", missed);
  }

  private String verdict(Room room) {
    if (room == Room.UNSERVED) {
      return "";
    }
    String missed = missed(room);
    String told = missed.isEmpty() ? "  met" : "  MISSED: " + missed;
    return isCalm() ? told : told + "; p99.9 unknown: the machine is busy";
  }

  /** Prints a row for each room, and returns whether all is as promised. */
  private boolean report() {
    System.out.printf(
        "%-14s %9s %9s %9s %8s %8s %7s%n",
        "who looks", "% of core", "p99.9 ms", "worst ms", "periods", "kB/s", "views/s");
    boolean met = true;
    for (Room room : Room.values()) {
      Result result = result(room);
      met &= room == Room.UNSERVED || missed(room).isEmpty();
      System.out.printf(
          Locale.ROOT,
          "%-14s %9.2f %9.3f %9.3f %8d %8.1f %7.1f%s%n",
          room.title,
          result.processor(),
          result.mostly(),
          result.worst(),
          result.late.length,
          Result.median(result.kilobytes),
          Result.median(result.views),
          verdict(room));
    }
    System.out.println(
        "views of who does not read: those that were waiting when it began to read again");
    System.out.println("at the end: " + Load.text());
    return met;
  }

  public static void main(String[] arguments) throws Exception {
    Path root = Path.of(System.getProperty("bench.root"));
    if (arguments.length == 0 && !Load.becomesCalm(System.err)) {
      System.err.println(
          "bench: the machine is busy (" + Load.text() + "): bench/studio 1 takes a rough look");
      System.exit(1);
    }
    System.err.println("bench: " + Load.text());
    System.setProperty("jdk.httpclient.receiveBufferSize", String.valueOf(RECEIVED));
    int rounds = arguments.length > 0 ? Integer.parseInt(arguments[0]) : ROUNDS;
    boolean met;
    try (StudioProbe unserved = new StudioProbe(root);
        StudioProbe served = new StudioProbe(root, "--studio=0")) {
      StudioBenchmark bench = new StudioBenchmark(unserved, served);
      System.err.println("bench: a round that only warms up both servers");
      bench.round();
      bench.results.clear();
      for (int round = 0; round < rounds; round++) {
        System.err.println("bench: round " + (round + 1) + " of " + rounds);
        bench.round();
      }
      met = bench.report();
    }
    if (Chromium.isThere()) {
      met &= StudioStartBenchmark.run(root);
      met &= StudioFramesBenchmark.run(root);
    } else {
      System.out.println("first jobs, frames: not measured, there is no chromedriver");
    }
    System.exit(met ? 0 : 1);
  }
}

package org.urbi.bench.remote;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * How long it takes from going to the studio to the first lines of jobs, as Chromium itself counts
 * it: with nothing kept of the page, and again with what it has kept. It needs chromium and
 * chromedriver.
 */
public final class StudioStartBenchmark {
  private static final int ROUNDS = 7;

  /** How long it may take, in milliseconds. */
  private static final int MOST = 1000;

  private static final Duration LIMIT = Duration.ofSeconds(60);

  private static final String BROWSER =
      """
      {"capabilities": {"alwaysMatch": {"goog:chromeOptions": {"args": ["--headless", "--no-sandbox", "--disable-gpu",
      "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"]}}}}
      """;

  private static final String FORGET = "{\"cmd\": \"Network.clearBrowserCache\", \"params\": {}}";

  private static final String SHOWN =
      "{\"script\": \"return document.querySelector('#list')?.dataset.since ?? ''\", \"args\": []}";

  private final HttpClient client = HttpClient.newHttpClient();
  private final String session;

  private StudioStartBenchmark(String driver) throws IOException, InterruptedException {
    session = driver + "/" + find("\"sessionId\":\"([^\"]+)\"", post(driver, BROWSER));
  }

  private static String find(String pattern, String text) throws IOException {
    Matcher found = Pattern.compile(pattern).matcher(text);
    if (!found.find()) {
      throw new IOException("unexpected: " + text);
    }
    return found.group(1);
  }

  private String post(String address, String json) throws IOException, InterruptedException {
    HttpRequest request =
        HttpRequest.newBuilder(URI.create(address))
            .header("content-type", "application/json")
            .timeout(LIMIT)
            .POST(HttpRequest.BodyPublishers.ofString(json))
            .build();
    return client.send(request, HttpResponse.BodyHandlers.ofString()).body();
  }

  /** Goes to a page, and returns after how many milliseconds it showed jobs. */
  private int open(String page) throws IOException, InterruptedException {
    post(session + "/url", "{\"url\": \"about:blank\"}");
    post(session + "/url", "{\"url\": \"" + page + "\"}");
    long deadline = System.nanoTime() + LIMIT.toNanos();
    while (System.nanoTime() < deadline) {
      Matcher shown =
          Pattern.compile("\"value\":\"(\\d+)\"").matcher(post(session + "/execute/sync", SHOWN));
      if (shown.find()) {
        return Integer.parseInt(shown.group(1));
      }
      Thread.sleep(Duration.ofMillis(50));
    }
    throw new IOException("no jobs are shown");
  }

  private static String await(InputStream from, String pattern) throws IOException {
    BufferedReader said = new BufferedReader(new InputStreamReader(from, StandardCharsets.UTF_8));
    List<String> all = new ArrayList<>();
    for (String line = said.readLine(); line != null; line = said.readLine()) {
      all.add(line);
      Matcher found = Pattern.compile(pattern).matcher(line);
      if (found.find()) {
        Thread.ofPlatform().daemon().start(() -> said.lines().forEach(each -> {}));
        return found.group(1);
      }
    }
    throw new IOException(String.join("\n", all));
  }

  /** Prints the median of all times, and returns whether it is as promised. */
  private static boolean print(String title, List<Integer> all) {
    List<Integer> sorted = all.stream().sorted().toList();
    int median = sorted.get(sorted.size() / 2);
    System.out.printf(
        Locale.ROOT,
        "%-32s %5d ms (%d to %d)  %s%n",
        title,
        median,
        sorted.getFirst(),
        sorted.getLast(),
        median <= MOST ? "met" : "MISSED: at most " + MOST + " ms");
    return median <= MOST;
  }

  private boolean measure(String page) throws IOException, InterruptedException {
    List<Integer> first = new ArrayList<>();
    List<Integer> again = new ArrayList<>();
    open(page);
    for (int round = 0; round < ROUNDS; round++) {
      post(session + "/goog/cdp/execute", FORGET);
      first.add(open(page));
      again.add(open(page));
    }
    return print("first jobs, nothing kept", first) & print("first jobs, the page is kept", again);
  }

  private void leave() throws IOException, InterruptedException {
    HttpRequest end = HttpRequest.newBuilder(URI.create(session)).timeout(LIMIT).DELETE().build();
    client.send(end, HttpResponse.BodyHandlers.discarding());
  }

  /** Measures it, and returns whether it is as promised. */
  static boolean run(Path root) throws IOException, InterruptedException {
    String urbi = root.resolve("urbi").toString();
    Process server =
        new ProcessBuilder(urbi, "-q", "-i", "--studio=0", "-e", "every (10ms) { 1 },")
            .redirectErrorStream(true)
            .start();
    Process driver =
        new ProcessBuilder("chromedriver", "--port=0").redirectErrorStream(true).start();
    try {
      String page = await(server.getInputStream(), "studio: (http\\S+)");
      String port = await(driver.getInputStream(), "successfully on port (\\d+)");
      StudioStartBenchmark bench =
          new StudioStartBenchmark("http://127.0.0.1:" + port + "/session");
      boolean met = bench.measure(page);
      bench.leave();
      return met;
    } finally {
      driver.destroy();
      server.destroy();
      server.waitFor();
    }
  }

  public static void main(String[] arguments) throws Exception {
    System.exit(run(Path.of(System.getProperty("bench.root"))) ? 0 : 1);
  }
}

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
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** A Chromium without a window, told what to do by chromedriver (W3C WebDriver). */
final class Chromium implements AutoCloseable {
  private static final Duration LIMIT = Duration.ofSeconds(60);

  private static final String OPTIONS =
      """
      {"capabilities": {"alwaysMatch": {"goog:chromeOptions": {"args": ["--headless", "--no-sandbox", "--disable-gpu",
      "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"]}}}}
      """;

  private final HttpClient client = HttpClient.newHttpClient();
  private final Process driver;
  private final String session;

  Chromium() throws IOException, InterruptedException {
    driver = new ProcessBuilder("chromedriver", "--port=0").redirectErrorStream(true).start();
    try {
      String port = await(driver.getInputStream(), "successfully on port (\\d+)");
      String address = "http://127.0.0.1:" + port + "/session";
      session = address + "/" + find("\"sessionId\":\"([^\"]+)\"", post(address, OPTIONS));
    } catch (IOException | InterruptedException | RuntimeException e) {
      driver.destroy();
      throw e;
    }
  }

  /** Whether there is one on this machine. */
  static boolean isThere() {
    return Stream.of(System.getenv("PATH").split(":"))
        .anyMatch(folder -> Files.isExecutable(Path.of(folder, "chromedriver")));
  }

  /** What a pattern finds in the first line of an output that has it; the rest is passed over. */
  static String await(InputStream from, String pattern) throws IOException {
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

  /** Goes to a page, from an empty one. */
  void open(String page) throws IOException, InterruptedException {
    post(session + "/url", "{\"url\": \"about:blank\"}");
    post(session + "/url", "{\"url\": \"" + page + "\"}");
  }

  /** Keeps nothing of the pages that it has seen. */
  void forget() throws IOException, InterruptedException {
    post(session + "/goog/cdp/execute", "{\"cmd\": \"Network.clearBrowserCache\", \"params\": {}}");
  }

  /**
   * Asks the page until what it answers is not empty any more.
   *
   * @param expression of JavaScript, without double quotes: a text, without any, too
   */
  String await(String expression) throws IOException, InterruptedException {
    String script = "{\"script\": \"return String(" + expression + ")\", \"args\": []}";
    long deadline = System.nanoTime() + LIMIT.toNanos();
    while (System.nanoTime() < deadline) {
      String answer = find("\"value\":(\"[^\"]*\"|.*)", post(session + "/execute/sync", script));
      if (!answer.startsWith("\"")) {
        throw new IOException(expression + ": " + answer);
      }
      if (answer.length() > 2) {
        return answer.substring(1, answer.length() - 1);
      }
      Thread.sleep(Duration.ofMillis(50));
    }
    throw new IOException("in vain: " + expression);
  }

  @Override
  public void close() {
    HttpRequest end = HttpRequest.newBuilder(URI.create(session)).timeout(LIMIT).DELETE().build();
    client.sendAsync(end, HttpResponse.BodyHandlers.discarding()).join();
    driver.destroy();
    driver.onExit().join();
  }
}

package org.urbi.tests.process;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.urbi.tests.TestTimeout;

/**
 * A Chromium without a window, in an empty profile of its own, that is told what to do by
 * chromedriver (W3C WebDriver).
 */
final class Browser implements AutoCloseable {
  private static final int POLL_MILLISECONDS = 150;
  private static final Pattern STARTED = Pattern.compile("started successfully on port (\\d+)");
  private static final Pattern SESSION = Pattern.compile("\"sessionId\":\"([^\"]+)\"");
  private static final Pattern TEXT = Pattern.compile("\\{\"value\":\"((?:[^\"\\\\]|\\\\.)*)\"\\}");

  private static final String[] OPTIONS = {
    "--headless",
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--window-size=1200,1000"
  };

  private static final String[] FLAT = {"--disable-gpu", "--disable-3d-apis"};
  private static final String[] SPATIAL = {
    "--use-angle=swiftshader", "--enable-unsafe-swiftshader"
  };

  private final HttpClient client = HttpClient.newHttpClient();
  private final Process driver;
  private String session;
  private boolean open;

  private Browser(Path program, Path folder, String[] graphics) throws IOException {
    ProcessBuilder builder =
        new ProcessBuilder("chromedriver", "--port=0").redirectErrorStream(true);
    // For its profile, and all else that it leaves behind.
    builder.environment().put("TMPDIR", folder.toString());
    driver = builder.start();
    try {
      session = "http://127.0.0.1:" + port() + "/session";
      String options =
          Stream.concat(Stream.of(OPTIONS), Stream.of(graphics))
              .map(each -> '"' + each + '"')
              .collect(Collectors.joining(","));
      String answer =
          post(
              "",
              "{\"capabilities\":{\"alwaysMatch\":{\"goog:chromeOptions\":{\"binary\":\""
                  + program
                  + "\",\"args\":["
                  + options
                  + "]}}}}");
      session += "/" + first(SESSION, answer);
      open = true;
    } catch (IOException | RuntimeException | Error e) {
      close();
      throw e;
    }
  }

  /** Starts one that keeps its files in a folder; the test is skipped where there is none. */
  static Browser start(Path folder) throws IOException {
    return start(folder, FLAT);
  }

  /** The same, and it draws in three dimensions: WebGL, computed by its processor. */
  static Browser startSpatial(Path folder) throws IOException {
    return start(folder, SPATIAL);
  }

  private static Browser start(Path folder, String[] graphics) throws IOException {
    Path chromium = inPath("chromium");
    assumeTrue(
        chromium != null && inPath("chromedriver") != null,
        "skipped: no chromium and chromedriver (Debian: chromium, chromium-driver)");
    return new Browser(chromium, folder, graphics);
  }

  private static Path inPath(String program) {
    return Stream.of(System.getenv("PATH").split(File.pathSeparator))
        .map(folder -> Path.of(folder, program))
        .filter(Files::isExecutable)
        .findFirst()
        .orElse(null);
  }

  private int port() throws IOException {
    BufferedReader said =
        new BufferedReader(new InputStreamReader(driver.getInputStream(), StandardCharsets.UTF_8));
    StringBuilder all = new StringBuilder();
    for (String line = said.readLine(); line != null; line = said.readLine()) {
      all.append(line).append('\n');
      Matcher started = STARTED.matcher(line);
      if (started.find()) {
        // What it says later is of no interest, but must not fill the pipe.
        Thread.ofPlatform().daemon().start(() -> said.lines().forEach(each -> {}));
        return Integer.parseInt(started.group(1));
      }
    }
    throw new AssertionError("chromedriver does not start:\n" + all);
  }

  private static String first(Pattern pattern, String text) {
    Matcher found = pattern.matcher(text);
    if (!found.find()) {
      throw new AssertionError("the browser answers: " + text);
    }
    return found.group(1);
  }

  private String post(String command, String json) throws IOException {
    return send(
        HttpRequest.newBuilder(URI.create(session + command))
            .POST(HttpRequest.BodyPublishers.ofString(json)));
  }

  private String send(HttpRequest.Builder request) throws IOException {
    try {
      HttpRequest built =
          request.header("content-type", "application/json").timeout(TestTimeout.LONG).build();
      return client.send(built, HttpResponse.BodyHandlers.ofString()).body();
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  /** Goes to a page, which must be there. */
  void open(String url) throws IOException {
    String answer = post("/url", "{\"url\":\"" + url + "\"}");
    if (!answer.equals("{\"value\":null}")) {
      throw new AssertionError("the browser does not open " + url + ": " + answer);
    }
  }

  /** Clicks, with a pointer as people have it, at a place of the window in pixels. */
  void click(int x, int y) throws IOException {
    String answer =
        post(
            "/actions",
            """
            {"actions":[{"type":"pointer","id":"mouse","parameters":{"pointerType":"mouse"},"actions":[
            {"type":"pointerMove","duration":0,"x":%d,"y":%d},
            {"type":"pointerDown","button":0},{"type":"pointerUp","button":0}]}]}
            """
                .formatted(x, y));
    if (!answer.equals("{\"value\":null}")) {
      throw new AssertionError("the browser does not click: " + answer);
    }
  }

  /** What the body of a function in JavaScript returns, as text. */
  String evaluate(String body) throws IOException {
    String script = "return String((() => {" + body + "})())";
    String escaped = script.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n");
    return first(TEXT, post("/execute/sync", "{\"script\":\"" + escaped + "\",\"args\":[]}"));
  }

  /** Evaluates until the result is as wanted, and returns that. */
  String await(String what, String body, Predicate<String> wanted)
      throws IOException, InterruptedException {
    long deadline = System.nanoTime() + TestTimeout.LONG.toNanos();
    while (true) {
      String result = evaluate(body);
      if (wanted.test(result)) {
        return result;
      }
      if (System.nanoTime() > deadline) {
        throw new AssertionError(what + ": still " + result);
      }
      Thread.sleep(POLL_MILLISECONDS);
    }
  }

  @Override
  public void close() {
    try {
      if (open) {
        send(HttpRequest.newBuilder(URI.create(session)).DELETE());
      }
      List<ProcessHandle> children = driver.descendants().toList();
      children.forEach(ProcessHandle::destroyForcibly);
      driver.destroy();
      driver.waitFor(TestTimeout.LONG);
      for (ProcessHandle child : children) {
        child.onExit().join();
      }
    } catch (IOException | InterruptedException e) {
      driver.destroyForcibly();
    }
  }
}

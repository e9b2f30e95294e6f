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
import java.time.Duration;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.urbi.tests.TestTimeout;

/**
 * A Chromium without a window, in an empty profile of its own, that is told what to do by
 * chromedriver (W3C WebDriver). To start one costs more than most that is done with it: all suites
 * of this JVM share two, one flat and one spatial, which end with the JVM.
 */
final class Browser {

  /** Between two questions: little at first, as most is there soon. */
  private static final long SHORTEST_PAUSE = 10;

  private static final long LONGEST_PAUSE = 100;
  private static final Duration LIMIT = TestTimeout.LONG;
  private static final int LONGEST_TEXT = 3000;
  private static final Pattern STARTED = Pattern.compile("started successfully on port (\\d+)");
  private static final Pattern IDENTIFIER = Pattern.compile("\"identifier\":\"([^\"]+)\"");
  private static final Pattern SESSION = Pattern.compile("\"sessionId\":\"([^\"]+)\"");
  private static final Pattern TEXT =
      Pattern.compile("\\{\"value\":\"((?:[^\"\\\\]++|\\\\.)*+)\"\\}");

  private static final List<String> OPTIONS =
      List.of(
          "--headless",
          "--no-sandbox",
          // It ends when chromedriver does, also when that is killed.
          "--remote-debugging-pipe",
          "--disable-quic",
          "--no-first-run",
          "--disable-background-networking",
          "--disable-component-update",
          "--disable-sync",
          "--window-size=1200,1000");

  private static final List<String> FLAT = List.of("--disable-gpu", "--disable-3d-apis");

  /** WebGL is computed in any case: all else is drawn as in the other one, which costs less. */
  private static final List<String> SPATIAL =
      List.of(
          "--use-angle=swiftshader",
          "--enable-unsafe-swiftshader",
          "--disable-gpu-rasterization",
          "--disable-accelerated-2d-canvas");

  private static final Map<List<String>, Browser> SHARED = new HashMap<>();

  private final HttpClient client = HttpClient.newHttpClient();

  /** For its profile, and all else that it leaves behind. */
  private final Path folder = Files.createTempDirectory("urbi-browser");

  private final Process driver;
  private String session;
  private boolean open;

  private Browser(Path program, List<String> graphics) throws IOException {
    ProcessBuilder builder =
        new ProcessBuilder("chromedriver", "--port=0").redirectErrorStream(true);
    builder.environment().put("TMPDIR", folder.toString());
    driver = builder.start();
    Guardian.ofThisJvm().guard(driver);
    Runtime.getRuntime().addShutdownHook(new Thread(this::end));
    try {
      session = "http://127.0.0.1:" + port() + "/session";
      String options =
          Stream.concat(OPTIONS.stream(), graphics.stream())
              .map(each -> '"' + each + '"')
              .collect(Collectors.joining(","));
      String answer =
          post(
              "",
              "{\"capabilities\":{\"alwaysMatch\":{\"timeouts\":{\"script\":"
                  + LIMIT.toMillis()
                  + "},\"goog:chromeOptions\":{\"binary\":\""
                  + program
                  + "\",\"args\":["
                  + options
                  + "]}}}}");
      session += "/" + first(SESSION, answer);
      open = true;
    } catch (IOException | RuntimeException | Error e) {
      end();
      throw e;
    }
  }

  /** The one that draws in two dimensions only; the test is skipped where there is no browser. */
  static Browser flat() throws IOException {
    return shared(FLAT);
  }

  /** The one that draws in three dimensions: WebGL, computed by its processor. */
  static Browser spatial() throws IOException {
    return shared(SPATIAL);
  }

  private static synchronized Browser shared(List<String> graphics) throws IOException {
    Path chromium = inPath("chromium");
    assumeTrue(
        chromium != null && inPath("chromedriver") != null,
        "skipped: no chromium and chromedriver (Debian: chromium, chromium-driver)");
    Browser known = SHARED.get(graphics);
    if (known == null || !known.driver.isAlive()) {
      known = new Browser(chromium, graphics);
      SHARED.put(graphics, known);
    }
    return known;
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
      HttpRequest built = request.header("content-type", "application/json").timeout(LIMIT).build();
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

  /** Leaves the page, which asks for nothing any more. */
  void leave() throws IOException {
    open("about:blank");
  }

  /** Has the screen of a telephone, and a finger instead of a mouse. */
  void becomeTelephone() throws IOException {
    command("Emulation.setDeviceMetricsOverride", screen(390, 844, true));
    command("Emulation.setTouchEmulationEnabled", "\"enabled\":true,\"maxTouchPoints\":2");
  }

  /** Has a screen of this size, in pixels, and a mouse. */
  void becomeScreen(int width, int height) throws IOException {
    command("Emulation.setDeviceMetricsOverride", screen(width, height, false));
    command("Emulation.setTouchEmulationEnabled", "\"enabled\":false");
  }

  /**
   * Has a system that prefers dark colours, or light ones.
   *
   * @param scheme {@code dark} or {@code light}; empty for what it usually has
   */
  void preferColours(String scheme) throws IOException {
    command(
        "Emulation.setEmulatedMedia",
        "\"features\":[{\"name\":\"prefers-color-scheme\",\"value\":\"" + scheme + "\"}]");
  }

  /** Has a screen as large as a wall. */
  void becomeWall() throws IOException {
    becomeScreen(3840, 2160);
  }

  /** Has the window again with which it began. */
  void becomeUsual() throws IOException {
    command("Emulation.clearDeviceMetricsOverride", "");
    command("Emulation.setTouchEmulationEnabled", "\"enabled\":false");
  }

  private static String screen(int width, int height, boolean mobile) {
    return "\"width\":%d,\"height\":%d,\"deviceScaleFactor\":1,\"mobile\":%b"
        .formatted(width, height, mobile);
  }

  /** A command of the protocol of Chromium's developer tools. */
  private String command(String name, String parameters) throws IOException {
    return demand(
        "/goog/cdp/execute", "{\"cmd\":\"" + name + "\",\"params\":{" + parameters + "}}");
  }

  /** What Chromium tells screen readers of the page, as the JSON of its protocol. */
  String accessibilityTree() throws IOException {
    return command("Accessibility.getFullAXTree", "");
  }

  private String demand(String command, String json) throws IOException {
    String answer = post(command, json);
    if (answer.contains("\"error\"")) {
      throw new AssertionError("the browser does not do it: " + answer);
    }
    return answer;
  }

  /**
   * Has each page that is opened from now on run a script before its own ones.
   *
   * @param script without quotation marks of its own
   * @return ends that
   */
  Closing beforeAll(String script) throws IOException {
    String answer =
        command("Page.addScriptToEvaluateOnNewDocument", "\"source\":\"" + script + "\"");
    String identifier = first(IDENTIFIER, answer);
    return () ->
        command(
            "Page.removeScriptToEvaluateOnNewDocument", "\"identifier\":\"" + identifier + "\"");
  }

  /** Something that lasts until it is closed. */
  interface Closing extends AutoCloseable {
    @Override
    void close() throws IOException;
  }

  /** Presses a key: a character, or one of those that WebDriver has in Unicode's private area. */
  void press(char key) throws IOException {
    String value = "\\u%04x".formatted((int) key);
    demand(
        "/actions",
        """
        {"actions":[{"type":"key","id":"keyboard","actions":[
        {"type":"keyDown","value":"%s"},{"type":"keyUp","value":"%s"}]}]}
        """
            .formatted(value, value));
  }

  /** Presses a key and keeps it, by the name that a page is told. */
  void hold(String key) throws IOException {
    command("Input.dispatchKeyEvent", "\"type\":\"keyDown\",\"key\":\"" + key + "\"");
  }

  /** Lets a key go, under the name that it has by then: with Shift it is another one. */
  void letGo(String key) throws IOException {
    command("Input.dispatchKeyEvent", "\"type\":\"keyUp\",\"key\":\"" + key + "\"");
  }

  /** Clicks, with a pointer as people have it, at a place of the window in pixels. */
  void click(int x, int y) throws IOException {
    demand(
        "/actions",
        """
        {"actions":[{"type":"pointer","id":"mouse","parameters":{"pointerType":"mouse"},"actions":[
        {"type":"pointerMove","duration":0,"x":%d,"y":%d},
        {"type":"pointerDown","button":0},{"type":"pointerUp","button":0}]}]}
        """
            .formatted(x, y));
  }

  /**
   * Draws two fingers apart at a place, to three times their distance. Chromium itself makes the
   * gesture: after two fingers of {@code /actions} it waits for the end of a touch on each later
   * page of the tab, and takes a swipe there for the one that goes back to the page before.
   */
  void spread(int x, int y) throws IOException {
    command(
        "Input.synthesizePinchGesture",
        "\"x\":%d,\"y\":%d,\"scaleFactor\":3,\"relativeSpeed\":2000,\"gestureSourceType\":\"touch\""
            .formatted(x, y));
  }

  /** Draws a finger across, from a place to another one. */
  void swipe(int x, int y, int to) throws IOException {
    demand(
        "/actions",
        """
        {"actions":[{"type":"pointer","id":"finger","parameters":{"pointerType":"touch"},"actions":[
        {"type":"pointerMove","duration":0,"x":%d,"y":%d},{"type":"pointerDown","button":0},
        {"type":"pointerMove","duration":50,"x":%d,"y":%d},{"type":"pointerUp","button":0}]}]}
        """
            .formatted(x, y, to, y));
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
    long deadline = System.nanoTime() + LIMIT.toNanos();
    for (long pause = SHORTEST_PAUSE; true; pause = Math.min(2 * pause, LONGEST_PAUSE)) {
      String result = evaluate(body);
      if (wanted.test(result)) {
        return result;
      }
      if (System.nanoTime() > deadline) {
        throw new AssertionError(what + ": still " + result + "; the page says:\n" + said());
      }
      Thread.sleep(pause);
    }
  }

  /** What somebody can read on the page, the beginning of it. */
  private String said() throws IOException {
    return evaluate("return document.body.innerText.slice(0, " + LONGEST_TEXT + ")")
        .replace("\\n", "\n");
  }

  private void end() {
    try {
      if (open) {
        send(HttpRequest.newBuilder(URI.create(session)).DELETE());
      }
      List<ProcessHandle> children = driver.descendants().toList();
      children.forEach(ProcessHandle::destroyForcibly);
      driver.destroyForcibly();
      driver.waitFor(LIMIT);
      for (ProcessHandle child : children) {
        child.onExit().join();
      }
      try (Stream<Path> left = Files.walk(folder)) {
        left.sorted(Comparator.reverseOrder()).map(Path::toFile).forEach(File::delete);
      }
    } catch (IOException | InterruptedException e) {
      driver.destroyForcibly();
    }
  }
}

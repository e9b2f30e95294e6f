package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.urbi.tests.process.SimulatedRobot.awaitTruth;

import java.net.ServerSocket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.tests.FreePorts;
import org.urbi.tests.TestTimeout;
import org.urbi.tests.process.JavaProcess.Setting;

/** The simulated robot as its user meets it: real processes, real time, a real browser. */
class SimulatedRobotTest {
  private static final String URBI = "org.urbi.server.cli.UrbiCommand";
  private static final String LAUNCH = "org.urbi.server.launch.UrbiLaunchJava";
  private static final String DEMO = "examples/ball-tracking/demo.u";
  private static final String ADDRESS = "Look at it: ";
  private static final String ALONE = "Its page: ";

  @TempDir static Path built;
  private static Setting root;

  @BeforeAll
  static void makeModule() {
    root = SimulatedRobot.setting(built);
  }

  /** How many different colours a canvas shows. */
  private static String colours(String canvas) {
    return """
    const canvas = document.querySelector('%s');
    if (!canvas || !canvas.width || !canvas.height) return 0;
    const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    return new Set(new Uint32Array(pixels.buffer)).size;
    """
        .formatted(canvas);
  }

  private static int number(String text) {
    return text.equals("undefined") ? 0 : Integer.parseInt(text);
  }

  @Test
  void demonstrationIsSeenAndTouchedInBrowsers(@TempDir Path folder) throws Exception {
    Browser flat = Browser.flat();
    Browser spatial = Browser.spatial();
    try (JavaProcess urbi = JavaProcess.start(root, URBI, List.of("-q", "-i", DEMO, "0"))) {
      String line = urbi.awaitText(ADDRESS);
      String address = line.substring(line.indexOf(ADDRESS) + ADDRESS.length());
      assertTrue(address.matches("http://localhost:\\d+/#robot"), address);
      flat.open(address);
      demonstrationIsSeen(flat, urbi);
      urbi.send("following.stop;\n");
      flat.leave();
      worldIsTouched(spatial, urbi);
      unusualWorldsAreShown(spatial, urbi, folder);
      urbi.send("shutdown;\n");
      spatial.await(
          "the loss of the connection",
          "return document.querySelector('#connection').dataset.state",
          "lost"::equals);
      spatial.leave();
      assertEquals(0, urbi.awaitEnd(), urbi::text);
      assertTrue(!urbi.text().contains("!!!"), urbi::text);
    }
  }

  private static void demonstrationIsSeen(Browser browser, JavaProcess urbi) throws Exception {
    goesFromTheStudioToThePage(browser);
    imagesComeAndShowTheBall(browser);
    everythingMoves(browser);
    Accessibility.check(browser);
    connectsAgain(browser, urbi);
    urbi.send("simulation.page.viewers;\n");
    urbi.awaitLine(said -> said.matches("\\[\\d+\\] 1"));
  }

  private static void goesFromTheStudioToThePage(Browser browser) throws Exception {
    String frame = "document.querySelector('#robot-frame iframe')";
    browser.await(
        "the page in the room of the robot",
        "return " + frame + "?.contentDocument?.querySelector('#connection')?.dataset.state",
        "live"::equals);
    Accessibility.check(browser);
    browser.becomeTelephone();
    String wide = frame + "?.contentDocument.documentElement";
    String whole =
        "return "
            + wide
            + ".scrollWidth <= 390 && "
            + wide
            + ".scrollHeight <= "
            + frame
            + ".offsetHeight";
    browser.await("the whole page on a telephone", whole, "true"::equals);
    String seen =
        """
        const page = %s.contentDocument;
        const world = page.querySelector('#world').getBoundingClientRect();
        const drives = page.querySelector('#drives');
        const { bottom, right } = drives.getBoundingClientRect();
        const { clientWidth, clientHeight } = page.documentElement;
        return world.width > clientWidth / 2 && world.bottom <= clientHeight
            && right > clientWidth - 50 && bottom <= clientHeight
            && drives.scrollHeight <= drives.clientHeight;
        """
            .formatted(frame);
    browser.becomeScreen(1920, 1080);
    browser.await("a large screen filled, and nothing out of sight", seen, "true"::equals);
    browser.becomeScreen(2560, 1440);
    browser.await("a larger one, too", seen, "true"::equals);
    browser.becomeUsual();
    browser.evaluate("document.querySelector('nav a[href=\"#jobs\"]').click()");
    browser.await("the room of the jobs", "return !!" + frame, "false"::equals);
    browser.open(browser.evaluate("return document.querySelector('#robot-alone').href"));
  }

  private static void imagesComeAndShowTheBall(Browser browser) throws Exception {
    browser.await("the camera's image", colours("#camera"), count -> number(count) > 100);
    String image = "return document.querySelector('#camera').dataset.image";
    int first = number(browser.evaluate(image));
    browser.await("the next images", image, count -> number(count) > first + 5);
    String seen = "return document.querySelector('#detection').dataset.seen";
    browser.await("the ball", seen, "true"::equals);
    // Something in the image is as yellow as the mark around the ball, and as red as the ball.
    browser.await(
        "the mark around the ball",
        """
        const canvas = document.querySelector('#camera');
        const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
        let marked = 0, red = 0;
        for (let i = 0; i < pixels.length; i += 4) {
          if (pixels[i] > 240 && pixels[i + 1] > 210 && pixels[i + 2] < 110) marked++;
          if (pixels[i] > 150 && pixels[i + 1] < 60 && pixels[i + 2] < 60) red++;
        }
        return marked > 50 && red > 50;
        """,
        "true"::equals);
    String where = "return document.querySelector('#detection').textContent";
    String before = browser.evaluate(where);
    browser.await("the detection", where, now -> !now.equals(before));
  }

  private static void everythingMoves(Browser browser) throws Exception {
    assertEquals(
        "neck.yaw neck.head.pitch wheel[left] wheel[right]",
        browser.evaluate(
            "return [...document.querySelectorAll('#plots b')].map(b => b.textContent).join(' ')"));
    String yaw = "document.querySelector('#plots canvas')";
    for (String what : List.of("samples", "value", "target")) {
      String part = "return " + yaw + ".dataset." + what;
      String before = browser.evaluate(part);
      assertNotEquals("undefined", before, what);
      browser.await(what, part, now -> !now.equals(before));
    }
    browser.await("the plot", colours("#plots canvas"), count -> number(count) > 3);
    browser.await("the scene", colours("#scene"), count -> number(count) > 20);
    for (String canvas : List.of("#plots canvas", "#scene", "#camera")) {
      String picture =
          """
          const text = document.querySelector('%s').toDataURL();
          let sum = 0;
          for (let i = 0; i < text.length; i++) sum = (31 * sum + text.charCodeAt(i)) | 0;
          return sum;
          """
              .formatted(canvas);
      String before = browser.evaluate(picture);
      browser.await(canvas, picture, now -> !now.equals(before));
    }
  }

  private static void connectsAgain(Browser browser, JavaProcess urbi) throws Exception {
    String connections = "return document.querySelector('#connection').dataset.connections";
    // A page that is served late, on a machine with much else to do, has connected again already.
    String first = browser.evaluate(connections);
    urbi.send("simulation.page.host = \"localhost\" | {};\n");
    browser.await("another connection", connections, now -> number(now) > number(first));
    String time = "return document.querySelector('#time').textContent";
    String before = browser.evaluate(time);
    browser.await("the time", time, now -> !now.equals(before));
  }

  /** How many different colours the world in three dimensions has. */
  private static final String SPACE =
      """
      const space = document.querySelector('#space');
      if (space.hidden || !space.dataset.time) return 0;
      const copy = document.createElement('canvas');
      [copy.width, copy.height] = [space.width, space.height];
      const pen = copy.getContext('2d');
      pen.drawImage(space, 0, 0);
      const pixels = pen.getImageData(0, 0, copy.width, copy.height).data;
      return new Set(new Uint32Array(pixels.buffer)).size;
      """;

  /** How many points of the world in three dimensions have a colour. */
  private static String painted(int red, int green, int blue) {
    int colour = 0xff << 24 | blue << 16 | green << 8 | red;
    return SPACE.replace(
        "new Set(new Uint32Array(pixels.buffer)).size",
        "new Uint32Array(pixels.buffer).filter(each => each === %d).length"
            .formatted(Integer.toUnsignedLong(colour)));
  }

  private static final String SHOWN_TIME =
      "return Math.round(document.querySelector('#space').dataset.time * 1000)";
  private static final String PICKED =
      "return document.querySelector('#space').dataset.picked || ''";

  private static void worldIsTouched(Browser browser, JavaProcess urbi) throws Exception {
    urbi.send("echo(\"" + ALONE + "\" + simulation.page.url);\n");
    String line = urbi.awaitText(ALONE);
    browser.open(line.substring(line.indexOf(ALONE) + ALONE.length()));
    browser.await("the world in three dimensions", SPACE, count -> number(count) > 50);
    browser.await("what the camera sees", painted(255, 179, 0), count -> number(count) > 2);
    String speed = "return document.querySelector('#speed').textContent";
    String shown = browser.await("its speed", speed, text -> text.startsWith("×"));
    assertTrue(Double.parseDouble(shown.substring(2)) < 2, "as fast as the clock: " + shown);
    browser.await("what the sonar measures", painted(229, 57, 47), count -> number(count) > 2);
    urbi.send("playing.stop;\n");
    timeIsHaltedAndStepped(browser, urbi);
    bodiesArePickedAndPushed(browser, urbi);
    // To draw the third dimension costs more than all else that follows.
    press(browser, "#flat");
    browser.await("the scene from above", colours("#scene"), count -> number(count) > 20);
    robotIsDriven(browser, urbi);
  }

  private static void unusualWorldsAreShown(Browser browser, JavaProcess urbi, Path folder)
      throws Exception {
    String none = "world { step 10 ms }\n";
    String crowd =
        IntStream.range(0, 1000)
            .mapToObj(i ->
                "body b%d { at %d %d 0; box { size 0.5 0.5 0.5 } }\n".formatted(i, i % 32, i / 32))
            .collect(Collectors.joining());
    for (String world : List.of(none, crowd)) {
      Path file = Files.writeString(folder.resolve("unusual.world"), world);
      String mark = world.equals(none) ? "Nothing: " : "Very much: ";
      urbi.send(
          "echo(\"%s\" + Simulation.new(\"%s\").showPage(0, nil).url);\n".formatted(mark, file));
      String line = urbi.awaitText(mark);
      browser.open(line.substring(line.indexOf("http")));
      // The first one is nothing but its background.
      int least = world.equals(none) ? 0 : 20;
      browser.await("the world", SPACE, count -> number(count) > least);
    }
  }

  private static void press(Browser browser, String button) throws Exception {
    browser.evaluate("document.querySelector('" + button + "').click(); return 1");
  }

  private static void key(Browser browser, String what, String key) throws Exception {
    browser.evaluate(
        "document.querySelector('#space').dispatchEvent(new KeyboardEvent('%s', {key: '%s', bubbles: true})); return 1"
            .formatted(what, key));
  }

  private static void timeIsHaltedAndStepped(Browser browser, JavaProcess urbi) throws Exception {
    press(browser, "#pause");
    browser.await(
        "the halt",
        "return document.querySelector('#pause').getAttribute('aria-pressed')",
        "true"::equals);
    int halted = number(browser.evaluate(SHOWN_TIME));
    press(browser, "#step");
    browser.await("a step of 2 ms", SHOWN_TIME, now -> number(now) == halted + 2);
    String time = StudioPage.text("#time");
    String told = "%.3f s".formatted((halted + 2) / 1000.0);
    browser.await("a step that is read", time, told::equals);
    String speed = StudioPage.text("#speed");
    assertEquals("–", browser.evaluate(speed), "a world that is halted has no speed");
    press(browser, "#reset");
    press(browser, "#step");
    browser.await("another step", SHOWN_TIME, now -> number(now) == halted + 4);
    browser.evaluate(
        "const pace = document.querySelector('#pace'); pace.value = 2; pace.dispatchEvent(new Event('change'))");
    awaitTruth(urbi, "twice as fast", "simulation.world.speed == 2");
  }

  private static void bodiesArePickedAndPushed(Browser browser, JavaProcess urbi) throws Exception {
    String middle =
        """
        const {left, top, width, height} = document.querySelector('#space').getBoundingClientRect();
        return Math.round(%s)
        """;
    int x = number(browser.evaluate(middle.formatted("left + width / 2")));
    int top = number(browser.evaluate(middle.formatted("top")));
    int height = number(browser.evaluate(middle.formatted("height")));
    for (int y = height / 4; y < height && browser.evaluate(PICKED).isEmpty(); y += 8) {
      browser.click(x, top + y);
    }
    assertNotEquals("", browser.evaluate(PICKED), "a click picks what is there");
    for (int i = 0; i < 20 && !browser.evaluate(PICKED).equals("ball"); i++) {
      key(browser, "keydown", "n");
    }
    assertEquals("ball", browser.evaluate(PICKED));
    String distance = "return document.querySelector('#space').dataset.distance";
    double far = Double.parseDouble(browser.evaluate(distance));
    browser.spread(x, top + height / 2);
    browser.await("two fingers", distance, now -> Double.parseDouble(now) < 0.7 * far);
    assertEquals("ball", browser.evaluate(PICKED), "fingers that move pick nothing");
    urbi.send("simulation.world.move(\"ball\", 0, 0, 0);\n");
    awaitTruth(urbi, "at rest", "simulation.world.velocity(\"ball\")[0] == 0");
    press(browser, "#push");
    press(browser, "#step");
    awaitTruth(
        urbi,
        "pushed",
        "simulation.world.velocity(\"ball\")[0].abs + simulation.world.velocity(\"ball\")[1].abs > 0.8");
  }

  private static void robotIsDriven(Browser browser, JavaProcess urbi) throws Exception {
    press(browser, "#pause");
    key(browser, "keydown", "w");
    awaitTruth(urbi, "driven", "robot.body.wheel[left].val > 2");
    key(browser, "keyup", "w");
    awaitTruth(urbi, "let go", "robot.body.wheel[left].val.abs < 0.1");
    key(browser, "keydown", "s");
    awaitTruth(urbi, "driven back", "robot.body.wheel[left].val < -2");
    key(browser, "keyup", "s");
    String button = "document.querySelector('[data-drive=\"1 0\"]').dispatchEvent(new Event('%s'))";
    browser.evaluate(button.formatted("pointerdown"));
    awaitTruth(urbi, "driven by a button", "robot.body.wheel[left].val > 2");
    browser.evaluate(button.formatted("pointerup"));
    awaitTruth(urbi, "the button let go", "robot.body.wheel[left].val.abs < 0.1");
    gamepadDrives(browser, urbi);
    key(browser, "keydown", "s");
    awaitTruth(urbi, "driven back again", "robot.body.wheel[left].val < -2");
    browser.evaluate("location.reload(); return 1");
    awaitTruth(urbi, "left alone", "robot.body.wheel[left].val.abs < 0.1");
    browser.await("the world again", SPACE, count -> number(count) > 50);
  }

  /** A stick that is pushed, let go, and pulled out while it is pushed. */
  private static void gamepadDrives(Browser browser, JavaProcess urbi) throws Exception {
    String stick = "navigator.getGamepads = () => [null, {axes: [0, %s]}];";
    String connected = "dispatchEvent(new Event('gamepadconnected')); return 1";
    browser.evaluate(stick.formatted("-1") + connected);
    awaitTruth(urbi, "driven by a stick", "robot.body.wheel[left].val > 2");
    browser.evaluate(stick.formatted("0.1") + "return 1");
    awaitTruth(urbi, "the stick let go", "robot.body.wheel[left].val.abs < 0.1");
    browser.evaluate(stick.formatted("-1") + "return 1");
    awaitTruth(urbi, "driven again", "robot.body.wheel[left].val > 2");
    browser.evaluate("navigator.getGamepads = () => [null, null]; return 1");
    awaitTruth(urbi, "pulled out", "robot.body.wheel[left].val.abs < 0.1");
  }

  @Test
  void recordingHasWhatWasDoneOnThePage(@TempDir Path folder) throws Exception {
    int port = FreePorts.next();
    Path program =
        Files.writeString(
            folder.resolve("paused.u"),
            """
            requireFile("urbi/sim.u")|;
            var s = Simulation.new("examples/ball-tracking/table.world")|;
            s.world.paused = true|;
            echo("%s" + s.showPage(%d, nil).url)|;
            waituntil (!s.world.paused)|;
            echo("It goes on.")|;
            shutdown;
            """
                .formatted(ADDRESS, port));
    String run = folder.resolve("run").toString();
    try (JavaProcess urbi =
        JavaProcess.start(root, URBI, List.of("--record=" + run, program.toString()))) {
      urbi.awaitText(ADDRESS);
      try (HttpClient client = HttpClient.newHttpClient()) {
        client
            .newWebSocketBuilder()
            .buildAsync(
                URI.create("ws://127.0.0.1:" + port + "/stream"), new WebSocket.Listener() {})
            .join()
            .sendText("pause 0", true)
            .join();
        assertEquals(0, urbi.awaitEnd(), urbi::text);
      }
    }
    try (JavaProcess replay = JavaProcess.start(root, URBI, List.of("--replay=" + run))) {
      assertEquals(0, replay.awaitEnd(), replay::text);
      assertTrue(replay.text().contains("It goes on."), replay::text);
    }
  }

  @Test
  void portInUseIsReportedAndTheDemoContinues() throws Exception {
    try (ServerSocket other = new ServerSocket(0);
        JavaProcess urbi =
            JavaProcess.start(
                root, URBI, List.of("-q", "-i", DEMO, String.valueOf(other.getLocalPort())))) {
      urbi.awaitText("cannot serve the studio on 127.0.0.1:" + other.getLocalPort());
      urbi.awaitText("./urbi examples/ball-tracking/demo.u PORT");
      urbi.send("simulation.world.time > 0;\n");
      urbi.awaitLine(line -> line.endsWith("] true"));
      urbi.send("shutdown;\n");
      assertEquals(0, urbi.awaitEnd(), urbi::text);
      assertTrue(!urbi.text().contains("internal error"), urbi::text);
    }
  }

  /** Half of the demo tells what is missing, and not what to do about ports. */
  @Test
  void whatTheDemoLacksIsNamed(@TempDir Path alone) throws Exception {
    Path demo = Files.copy(SimulatedRobot.ROOT.resolve(DEMO), alone.resolve("demo.u"));
    List<String> words = List.of("-q", "--errors", "explained", demo.toString(), "0");
    try (JavaProcess urbi = JavaProcess.start(root, URBI, words)) {
      urbi.awaitText("load: file not found: tracking.u");
      urbi.awaitText("`simulation' may come from what was not loaded at " + demo + ":6.1-18");
      urbi.send("shutdown;\n");
      urbi.awaitEnd();
      assertTrue(!urbi.text().contains("goes on without the studio"), urbi::text);
    }
  }

  /** The same devices, in a process of their own: nothing but the clock differs. */
  @Test
  void devicesRunInAProcessOfTheirOwn() throws Exception {
    String module = built.resolve("sim.jar").toString();
    try (ServerProcess server = ServerProcess.in(SimulatedRobot.ROOT);
        JavaProcess devices =
            JavaProcess.start(
                root, LAUNCH, List.of("--port", String.valueOf(server.port()), module))) {
      devices.awaitText("running on 127.0.0.1:" + server.port());
      try (ConsoleClient client = server.connect()) {
        assertEquals(
            List.of(),
            client.answers(
                """
                requireFile("urbi/sim.u")|;
                var Global.s = Simulation.new("examples/ball-tracking/table.world")|;
                var Global.robot = s.robot|;
                robot.makeCompactNames|;
                var Global.ball = BallDetector.new(camera.__uobjectName + ".val")|;
                """));
        assertEquals("true", answer(client, "robot.isA(Interface.Mobile)"));
        motorsAndSensors(client);
        visionAndMistakes(client);
        devices.terminate();
        awaitAnswer(client, "uobjects.hasLocalSlot(\"SimServo\")", "false");
      }
      assertEquals(0, server.shutDown(), server::text);
    }
  }

  private static void motorsAndSensors(ConsoleClient client) throws Exception {
    client.answers("yaw.val = 0.4;");
    awaitAnswer(client, "(yaw.val - 0.4).abs < 0.01 && (yaw.angle - 0.4).abs < 0.01", "true");
    assertEquals("true", answer(client, "yaw.val->rangemax > 2"));
    client.answers("wheel.val = 2;");
    awaitAnswer(client, "(wheelL.val - 2).abs < 0.2 && (wheelR.speed - 2).abs < 0.2", "true");
    awaitAnswer(client, "s.world.position(\"body\")[0] > 0.02", "true");
    client.answers("wheel.val = 0;");
    awaitAnswer(client, "wheelL.val.abs < 0.01", "true");
    awaitAnswer(client, "(robot.body.accel[z].val - 9.81).abs < 0.5", "true");
    // What the sonar is to see stays in its beam. The ball is beside it: its top is just as high.
    client.answers(
        """
        var Global.x = s.world.position("body")[0]|;
        s.world.move("ball", 0, 0, 0)|; s.world.place("ball", x + 1, 0.15, 0.06)|;
        s.world.place("north", x + 1.2, 0, 0.1)|;
        """);
    // The robot may have rolled on for as long as it took its wheels to hear that they should stop.
    awaitAnswer(
        client,
        "(robot.body.sonar[front].distance + s.world.position(\"body\")[0] - (x + 0.99)).abs < 0.01",
        "true");
  }

  private static void visionAndMistakes(ConsoleClient client) throws Exception {
    assertEquals("\"rgb 320 240\"", answer(client, "camera.val.keywords"));
    awaitAnswer(client, "ball.visible", "1");
    assertEquals("true", answer(client, "ball.x > 0"), "on the right");
    String told = said(client, "s.world.place(\"nothing\", 1, 2, 3)");
    assertTrue(told.contains("no body 'nothing' in this world; it has ground, north"), told);
    client.answers("yaw.val = nan; yaw.P = -1; camera.format = 99;");
    awaitAnswer(client, "camera.format", "1");
    awaitAnswer(client, "yaw.P", "20");
    assertEquals("true", answer(client, "(yaw.val - 0.4).abs < 0.01"), "as before");
  }

  @Test
  void demoReportsMissingNativeLibrariesAndContinues(@TempDir Path folder) throws Exception {
    Path notAFolder = Files.writeString(folder.resolve("file"), "");
    Path broken = Files.writeString(folder.resolve("broken.world"), "body x {\n  mass 1 cm\n}\n");
    Setting bare =
        root.with(
            "JAVA_TOOL_OPTIONS",
            "-Durbi.libode=/no/such/libode.so -Durbi.cache=" + notAFolder.resolve("cache"));
    try (JavaProcess urbi = JavaProcess.start(bare, URBI, List.of("-P", "0"));
        ServerProcess server = new ServerProcess(urbi);
        ConsoleClient client = server.connect()) {
      client.answers(
          """
          requireFile("urbi/sim.u")|;
          var Global.s = Simulation.new("examples/ball-tracking/table.world")|;
          s.robot.makeCompactNames|;
          """);
      assertTrue(answer(client, "s.world.engine").contains("ode4j"));
      assertTrue(
          answer(client, "s.world.whyNotNative").contains("libode not found (looked for /no/such"));
      client.answers("yaw.val = 0.4;");
      awaitAnswer(client, "(yaw.val - 0.4).abs < 0.01", "true");
      assertEquals("\"jpeg 320 240\"", answer(client, "camera.format = 3 | camera.val.keywords"));
      String told = said(client, "BallDetector.new(camera.__uobjectName + \".val\")");
      assertTrue(told.contains("OpenCV cannot be unpacked: "), told);
      told = said(client, "ImageFilter.new(camera.__uobjectName + \".val\")");
      assertTrue(told.contains("OpenCV cannot be unpacked: "), told);
      told = said(client, "Simulation.new(\"" + broken + "\")");
      assertTrue(
          told.contains("broken.world:2.10: mass: unknown unit 'cm'; it is in kg or g"), told);
      told = said(client, "s.showPage(77777, nil)");
      assertTrue(told.contains("page: port: between 0 and 65535 expected, not 77777"), told);
      assertTrue(answer(client, "s.showPage(0, nil).url").startsWith("\"http://localhost:"));
      assertEquals("3", answer(client, "1 + 2"));
      assertEquals(0, server.shutDown(), server::text);
      assertTrue(!server.text().contains("internal error"), server::text);
    }
  }

  /** All that is answered to an expression. */
  private static String said(ConsoleClient client, String expression) throws Exception {
    return String.join("\n", client.answers(expression + ";"));
  }

  /** What an expression is. */
  private static String answer(ConsoleClient client, String expression) throws Exception {
    List<String> lines = client.answers(expression + ";");
    return lines.isEmpty() ? "" : lines.getLast().replaceFirst("^\\[\\d+\\] ", "");
  }

  /** Asks until an expression is as expected. */
  private static void awaitAnswer(ConsoleClient client, String expression, String expected)
      throws Exception {
    long deadline = System.nanoTime() + TestTimeout.LONG.toNanos();
    String last = answer(client, expression);
    while (!last.equals(expected)) {
      assertTrue(System.nanoTime() < deadline, expression + " is still " + last);
      Thread.sleep(50);
      last = answer(client, expression);
    }
  }
}

package org.urbi.sim.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.kernel.log.LogLevel;
import org.urbi.sim.vision.OpenCv;

/** The devices as urbiscript sees them, plugged into a kernel in virtual time. */
class DevicesTest {
  @TempDir static Path folder;

  private final BlockingQueue<String> output = new LinkedBlockingQueue<>();
  private final BlockingQueue<String> logged = new LinkedBlockingQueue<>();
  private Kernel kernel;

  @BeforeAll
  static void makeJar() throws Exception {
    SimJar.writeTo(folder);
  }

  @BeforeEach
  void start() {
    kernel = kernel(output, logged);
    build(kernel);
  }

  private static Kernel kernel(BlockingQueue<String> output, BlockingQueue<String> logged) {
    return Kernel.builder()
        .virtualTime(true)
        .searchPath(List.of(Path.of("../share"), Path.of("../examples/ball-tracking")))
        .moduleSearchPath(List.of(folder))
        .output(output::add)
        .logLevel(LogLevel.LOG)
        .log(logged::add)
        .start();
  }

  private static void build(Kernel kernel) {
    kernel.eval(
        """
        requireFile("urbi/sim.u");
        var Global.s = Simulation.new("table.world");
        var Global.robot = s.robot;
        robot.makeCompactNames|
        """);
  }

  @AfterEach
  void stop() {
    kernel.close();
  }

  private double number(String code) {
    return kernel.eval(code, double.class);
  }

  private void refused(String code, String message) {
    String text = assertThrows(UrbiError.class, () -> kernel.eval(code)).getMessage();
    assertTrue(text.contains(message), text);
  }

  /** What an error of a notification said; it goes to people, not to who has written. */
  private void complained(String message) {
    String all = String.join("\n", output);
    assertTrue(all.contains(message), all);
    output.clear();
  }

  @Test
  void devicesStandWhereTheStandardWantsThem() {
    assertEquals(
        List.of("robot.body.neck.head.camera", "robot.body.wheel[left]", "robot.body.accel[z]"),
        kernel.eval(
            "[robot.body.neck.head.camera.fullname, robot.body.wheel[left].fullname,"
                + " robot.body.accel[z].fullname]"));
    assertEquals(
        true,
        kernel.eval(
            "robot.body.neck.yaw.isA(Interface.RotationalMotor)"
                + " && robot.body.wheel[right].isA(Interface.RotationalSpeedMotor)"
                + " && robot.body.neck.head.camera.isA(Interface.VideoIn)"
                + " && robot.body.sonar[front].isA(Interface.DistanceSensor)"
                + " && robot.body.led.isA(Interface.RGBLed)"
                + " && robot.isA(Interface.Mobile)"));
    assertEquals("Scout", kernel.eval("robot.name"));
  }

  @Test
  void servoIsSensedOneStepAfterItsCommand() {
    assertEquals(0, number("yaw.val"), 1e-9);
    assertTrue(number("yaw.val = 0.5 | sleep(2ms) | yaw.val") > 0.001, "one step of 2 ms later");
    assertEquals(0.5, number("sleep(2s) | yaw.val"), 1e-3);
    assertEquals(0.5, number("yaw.angle"), 1e-3);
    assertEquals(0.5 / (2 * Math.PI), number("yaw.turn"), 1e-3);
    assertEquals(20, number("yaw.PGain"));
  }

  @Test
  void servoStaysInItsRange() {
    double limit = Math.toRadians(120);
    assertEquals(-limit, number("yaw.val->rangemin"), 1e-9);
    assertEquals(limit, number("yaw.val = 9 | sleep(2s) | yaw.val"), 1e-2);
    kernel.eval("yaw.val = nan | sleep(1s)");
    complained("neck.yaw: target: not a finite number: NaN");
    assertEquals(limit, number("yaw.val"), 1e-2, "as before");
    kernel.eval("yaw.val = \"fast\" | sleep(100ms)");
    complained("neck.yaw: target: a number expected, not \"fast\"");
    kernel.eval("yaw.val = [1] | sleep(100ms)");
    complained("neck.yaw: target: a number expected, not [1]");
    kernel.eval("yaw.val = inf | sleep(100ms)");
    assertEquals(limit, number("yaw.val"), 1e-2, "as far as it goes");
    kernel.eval("wheelL.val = nan | sleep(100ms)");
    complained("wheel[left]: target: not a finite number: NaN");
    assertEquals(0, number("wheelL.val"), 1e-2, "as before");
    kernel.eval("yaw.P = -1; sleep(10ms)");
    complained("neck.yaw: gain: 0 or more expected, not -1.0");
    assertEquals(20, number("yaw.P"), "as before");
    kernel.eval("yaw.P = inf; sleep(10ms)");
    complained("neck.yaw: gain: not a finite number: Infinity");
    kernel.eval("yaw.speed = nan; sleep(10ms)");
    complained("neck.yaw: speed: not a finite number: NaN");
    assertEquals(4, number("yaw.speed"), "as before");
    kernel.eval("yaw.load = 2; sleep(10ms)");
    complained("neck.yaw: load: between 0 and 1 expected, not 2.0");
  }

  @Test
  void oneWarningEachTimeATargetLeavesItsRange() {
    kernel.eval("yaw.val = 2 | yaw.val = 2.5 | yaw.val = 9 | yaw.val = 3; sleep(10ms)");
    assertEquals(1, logged.size(), logged.toString());
    String warning = logged.poll();
    assertTrue(
        warning.matches(
            "warning: SimServo_0x[0-9a-f]+\\.val: 2.5 is more than 2.094\\d+, the rangemax:"
                + " limited to that"),
        warning);
    kernel.eval("yaw.val = 1 | yaw.val = -7 | yaw.val = -1; sleep(10ms)");
    assertTrue(logged.poll().contains(".val: -7.0 is less than -2.094"));
    kernel.eval("wheelL.val = 99 | wheelL.val = 0; sleep(10ms)");
    assertTrue(logged.poll().contains("SimWheel_"));
    assertTrue(logged.isEmpty(), logged.toString());
    assertTrue(output.isEmpty(), "nothing is said in the session: " + output);
  }

  @Test
  void speedLimitsHowFastAServoMoves() {
    assertEquals(0.5, number("yaw.speed = 0.5 | yaw.val = 1 | sleep(1s) | yaw.val"), 0.02);
    // Without force it can be moved by whatever comes; gravity does nothing to a yaw.
    assertEquals(0.5, number("yaw.load = 0 | yaw.val = -1 | sleep(1ms) | yaw.val"), 0.05);
  }

  @Test
  void robotDrivesAndTurns() {
    kernel.eval("robot.go(0.5); sleep(500ms)");
    List<?> place = (List<?>) kernel.eval("s.world.position(\"body\")");
    assertEquals(0.5, (Double) place.getFirst(), 0.05);
    kernel.eval("robot.turn(1); sleep(500ms)");
    assertEquals(1, number("s.world.orientation(\"body\")"), 0.3);
    assertEquals(false, kernel.eval("robot.moving"));
  }

  @Test
  void wheelsAreBroadcastTo() {
    kernel.eval("robot.body.wheel.val = 2; sleep(1s)");
    assertEquals(2, number("wheelL.val"), 0.1);
    assertEquals(2, number("wheelR.speed"), 0.1);
  }

  @Test
  void sensorsMeasureAndAreWatched() {
    kernel.eval("s.world.place(\"ball\", 2.5, 0, 0.06); sleep(1s)");
    assertEquals(9.81, number("robot.body.accel[z].val"), 0.1);
    assertEquals(0, number("robot.body.gyro[z].val"), 0.01);
    kernel.eval("s.world.move(\"ball\", 0, 0, 0); s.world.place(\"ball\", 1, 0, 0.12); sleep(2ms)");
    assertEquals(1 - 0.16 - 0.06, number("robot.body.sonar[front].distance"), 0.02);
    kernel.eval("at (robot.body.touch[front].val == 1) echo(\"bump\"); robot.go(3),");
    kernel.eval("sleep(20s)");
    assertTrue(String.join("", output).contains("bump"), "at the ball or the wall");
  }

  @Test
  void cameraGivesImages() {
    assertEquals("rgb 320 240", kernel.eval("camera.val.keywords"));
    assertEquals("jpeg 320 240", kernel.eval("camera.format = 3 | camera.val.keywords"));
    assertEquals(
        "rgb 160 120",
        kernel.eval("camera.format = 1 | camera.resolution = 1 | camera.val.keywords"));
    assertEquals(160, number("camera.width"));
    kernel.eval("camera.resolution = 17; sleep(10ms)");
    complained("neck.head.camera: resolution: between 0 and 3 expected, not 17");
    assertEquals(1, number("camera.resolution"), "as before");
    kernel.eval("camera.format = 77; sleep(10ms)");
    complained("neck.head.camera: format: one of 1 (rgb)");
    kernel.eval("camera.quality = nan; sleep(10ms)");
    complained("neck.head.camera: quality: between 0 and 100 expected, not nan");
  }

  @Test
  void ballIsSeenAndLost() {
    assumeTrue(OpenCv.isAvailable(), "skipped: OpenCV has no native library for this machine");
    kernel.eval(
        """
        var Global.ball = BallDetector.new(camera.__uobjectName + ".val");
        s.world.move("ball", 0, 0, 0);
        s.world.place("ball", 1.5, 0.3, 0.06);
        at (ball.visible) echo("seen") onleave echo("lost");
        sleep(300ms);
        """);
    assertEquals(1, number("ball.visible"));
    assertTrue(number("ball.x") < -0.1, "on the left");
    assertTrue(number("ball.y") < -0.05, "below the horizon");
    assertTrue(number("ball.ratio") > 0.001);
    kernel.eval("s.world.place(\"ball\", -0.8, 0, 0.06); sleep(300ms)");
    assertEquals(0, number("ball.visible"));
    String all = String.join("", output);
    assertTrue(all.contains("seen") && all.indexOf("lost") > all.indexOf("seen"), all);
  }

  @Test
  void coloursAreMappedAndImagesFiltered() {
    assumeTrue(OpenCv.isAvailable(), "skipped: OpenCV has no native library for this machine");
    kernel.eval(
        """
        s.world.place("ball", 1, 0, 0.06);
        s.world.move("ball", 0, 0, 0);
        var Global.colours = ColourMapper.new(camera.__uobjectName + ".val");
        colours.define("red", 345, 15, 0.5, 1, 0.2, 1,  1, 0, 0);
        var Global.edges = ImageFilter.new(camera.__uobjectName + ".val");
        edges.kind = "edges";
        sleep(300ms);
        """);
    Map<?, ?> shares = (Map<?, ?>) kernel.eval("colours.shares");
    assertTrue((Double) shares.get("red") > 0.005, shares.toString());
    assertEquals("rgb 320 240", kernel.eval("edges.val.keywords"));
    kernel.eval("edges.kind = \"magic\"; sleep(10ms)");
    complained("unknown filter 'magic'");
  }

  @Test
  void timeIsHaltedSteppedAndHurried() {
    double before = number("s.world.paused = true | sleep(100ms) | s.world.time");
    assertEquals(before, number("sleep(5s) | s.world.time"));
    assertEquals(before + 0.02, number("s.world.step(10) | s.world.time"), 1e-9);
    assertEquals(before + 1.02, number("s.world.paused = false | sleep(1s) | s.world.time"), 0.05);
    assertEquals(before + 4.02, number("s.world.speed = 3 | sleep(1s) | s.world.time"), 0.15);
    assertEquals(0, number("s.world.late"), "nothing was lost");
    kernel.eval("s.world.speed = 0; sleep(10ms)");
    complained("speed: above 0 and at most 10.0 expected, not 0.0");
    kernel.eval("s.world.speed = nan; sleep(10ms)");
    complained("speed: above 0 and at most 10.0 expected, not NaN");
    assertEquals(3, number("s.world.speed"), "as before");
  }

  @Test
  void resetPutsEverythingBack() {
    kernel.eval("yaw.val = 1 | robot.go(0.3) | robot.drive(0.2, 0) | sleep(1s)");
    double before = number("s.world.time");
    assertTrue(number("wheelL.angle") > 3);
    kernel.eval("s.world.paused = true | s.world.reset");
    assertEquals(before, number("s.world.time"), 0.1, "time goes on");
    assertEquals(List.of(1.5, 0.4, 0.06), kernel.eval("s.world.position(\"ball\")"));
    assertEquals(List.of(0.2, -0.8, 0.0), kernel.eval("s.world.velocity(\"ball\")"));
    assertEquals(0, number("s.world.position(\"body\")[0]"), 1e-9);
    assertEquals(0, number("wheelL.angle"), 1e-6);
    assertEquals(0, number("yaw.val"), 1e-6);
    kernel.eval("s.world.paused = false | sleep(2s)");
    assertEquals(0, number("yaw.val"), 1e-2, "nothing is to move");
    assertEquals(0, number("s.world.position(\"body\")[0]"), 0.02);
  }

  @Test
  void hitMakesABodyFaster() {
    kernel.eval(
        "s.world.paused = true | s.world.place(\"ball\", 1, 0, 0.06)"
            + " | s.world.move(\"ball\", 0, 0, 0) | s.world.hit(\"ball\", 1, 0, 0.06, 2, 0, 0)");
    assertEquals(2, number("s.world.step(1) | s.world.velocity(\"ball\")[0]"), 0.1);
    assertEquals(2, number("s.world.step(1) | s.world.velocity(\"ball\")[0]"), 0.1, "once");
    refused("s.world.hit(\"north\", 0, 0, 0, 1, 0, 0)", "north: does not move: it has no mass");
    refused("s.world.hit(\"ball\", 0, 0, 0, nan, 0, 0)", "ball: the force is not finite");
    refused("s.world.hit(\"ball\", inf, 0, 0, 1, 0, 0)", "ball: the point is not finite");
  }

  @Test
  void whoLooksMayIntervene() {
    kernel.eval("var Global.page = s.showPage(0, nil)");
    obey("drive 1 0");
    assertTrue(number("sleep(1s) | wheelL.val") > 1);
    assertEquals(number("wheelL.val"), number("wheelR.val"), 0.2);
    obey("drive 0 0");
    assertEquals(0, number("sleep(1s) | wheelL.val"), 0.01);
    obey("pause 1");
    double halted = number("sleep(1s) | s.world.time");
    obey("step 5");
    assertEquals(halted + 0.01, number("s.world.time"), 1e-9);
    obey("hit 0 0 0 1 0 0 nothing");
    obey("hit 0 0 0 1 0 0");
    obey("hit 1 2 3");
    obey("step 100000");
    obey("step -1");
    obey("drive nan 0");
    obey("drive");
    obey("speed 1e9");
    obey("");
    obey("fly");
    assertEquals(halted + 0.01, number("sleep(1s) | s.world.time"), 1e-9, "nothing was done");
    assertEquals(0, output.size(), "only who looks is told");
    obey("reset");
    assertEquals(0, number("s.world.position(\"body\")[0]"), 1e-9);
    obey("pause 0");
    assertTrue(number("sleep(1s) | s.world.time") > halted + 0.5);
  }

  /** A key that is let go and another one that is pressed, at once: nothing of both is mixed. */
  @Test
  void lastOfTheOrdersOfOneMomentCounts() {
    kernel.eval("var Global.page = s.showPage(0, nil)");
    double fast = drivenBy("drive 1 0");
    assertTrue(fast > 1, "" + fast);
    assertEquals(0, drivenBy("drive 1 0", "drive 0 0"), 0.01, "let go");
    assertEquals(fast, drivenBy("drive 0 0", "drive 1 0"), 0.01, "pressed");
    assertEquals(-fast, drivenBy("drive 1 0", "drive 0 0", "drive -1 0"), 0.01, "and back");
    assertEquals(0, drivenBy("drive -1 0", "drive 1 0", "drive 0 0"), 0.01, "let go again");
  }

  /** How fast a wheel is after orders that come in one cycle. */
  private double drivenBy(String... orders) {
    StringBuilder all = new StringBuilder();
    for (String order : orders) {
      all.append("page.obey(\"nobody\", \"").append(order).append("\") | ");
    }
    return number(all + "sleep(1s) | wheelL.val");
  }

  @Test
  void simulationWithAPageIsKept() {
    String name = ".__uobjectName";
    String shown =
        kernel.eval("Simulation.new(\"table.world\").showPage(0, nil)" + name, String.class);
    String forgotten = kernel.eval("SimPage.new(s.world" + name + ", 0)" + name, String.class);
    kernel.eval("SimPage.new(s.world" + name + ", 0)|");
    for (int i = 0; i < 500 && isThere(forgotten); i++) {
      System.gc();
      kernel.eval("sleep(1ms)");
    }
    assertFalse(isThere(forgotten));
    assertTrue(isThere(shown));
  }

  private boolean isThere(String name) {
    return kernel.eval("uobjects.hasLocalSlot(\"" + name + "\")", boolean.class);
  }

  private void obey(String order) {
    kernel.eval("page.obey(\"nobody\", \"" + order + "\")");
  }

  @Test
  void nonsenseIsAnException() {
    refused("s.world.place(\"nothing\", 1, 0, 0)", "no body 'nothing' in this world");
    refused("s.world.place(\"ball\", nan, 0, 0)", "ball: the place is not finite");
    refused("SimWorld.new(\"/nonexistent.world\")", "/nonexistent.world: no such file");
    refused("SimServo.new(\"nobody\", \"neck.yaw\")", "no simulated world 'nobody'");
    refused("SimServo.new(s.world.__uobjectName, \"elbow\")", "no drive 'elbow' in this world");
    refused("SimServo.new(s.world.__uobjectName, \"wheel[left]\")", "use SimWheel");
    refused("s.world.move(\"ball\", inf, 0, 0)", "ball: the velocity is not finite");
    refused("s.world.move(\"ball\", 1e300, 0, 0)", "ball: the velocity: between -10000.0 and");
    refused("s.world.push(\"ball\", 0, -inf, 0)", "ball: the force is not finite");
    refused("s.world.place(\"ball\", 1e12, 0, 0)", "ball: the place: between -1000000.0 and");
    refused("s.world.picture(0, 0, nan, 0, 0, 1, 10, 10)", "picture: not a finite number");
    refused("s.world.step(-1)", "step: 0 or more expected, not -1");
    assertEquals(3, number("1 + 2"), "the kernel goes on");
  }

  @Test
  void twoRunsGiveTheSameOutput() {
    String program =
        """
        yaw.val = 0 sin:2s ampli:0.5,
        robot.turn(2),
        for| (var i: 20) {
          sleep(170ms)|
          echo([yaw.val, wheelL.torque, s.world.position("ball"), robot.body.accel[x].val])
        };
        echo(camera.val.data)
        """;
    List<String> runs =
        java.util.stream.Stream.generate(
                () -> {
                  BlockingQueue<String> said = new LinkedBlockingQueue<>();
                  try (Kernel other = kernel(said, new LinkedBlockingQueue<>())) {
                    build(other);
                    other.eval(program);
                  }
                  return String.join("\n", said);
                })
            .limit(2)
            .toList();
    assertTrue(runs.getFirst().length() > 1000);
    assertEquals(runs.getFirst(), runs.getLast());
  }
}

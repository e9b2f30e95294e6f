package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.server.make.UmakeJava;
import org.urbi.tests.FreePorts;
import org.urbi.tests.process.JavaProcess.Setting;

/**
 * {@code examples/ros} and a server in the environment of ROS 1, with Debian's roscore and rospy.
 */
class RosExamplesTest {
  private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();
  static final String URBI = "org.urbi.server.cli.UrbiCommand";

  @TempDir static Path folder;
  private static int port;
  private static Process core;
  private static Setting root;

  @BeforeAll
  static void startMaster() throws IOException {
    assumeTrue(
        Stream.of("rospy", "nav_msgs", "sensor_msgs", "geometry_msgs")
            .allMatch(each -> Files.isDirectory(Path.of("/usr/lib/python3/dist-packages", each))),
        "there is no ROS 1 on this machine");
    makeModules(folder);
    port = FreePorts.next();
    core = master(port);
    root =
        Setting.in(ROOT)
            .with("URBI_UOBJECT_PATH", folder.toString())
            .with("ROS_MASTER_URI", "http://127.0.0.1:" + port);
  }

  private static Process master(int port) throws IOException {
    return ros("/usr/bin/rosmaster", "--core", "-p", "" + port).start();
  }

  /** Writes the modules that the robot consists of into a folder. */
  static void makeModules(Path folder) throws IOException {
    make("sim-devices", folder.resolve("sim.jar"));
    make("urbi-ros", folder.resolve("urbi/ros.jar"));
  }

  private static void make(String module, Path file) throws IOException {
    Path classes = ROOT.resolve(Path.of(module, "target", "classes"));
    assertTrue(Files.isDirectory(classes), classes + " is built before");
    Files.createDirectories(file.getParent());
    ByteArrayOutputStream output = new ByteArrayOutputStream();
    PrintStream printer = new PrintStream(output, true, StandardCharsets.UTF_8);
    String[] words = {"-q", classes.toString(), "-o", file.toString()};
    int status = UmakeJava.run(words, printer, printer);
    assertEquals("0 ", status + " " + output.toString(StandardCharsets.UTF_8));
  }

  private static ProcessBuilder ros(String... command) {
    ProcessBuilder builder = new ProcessBuilder(command).directory(ROOT.toFile());
    builder.environment().put("ROS_MASTER_URI", "http://127.0.0.1:" + port);
    builder.environment().put("ROS_IP", "127.0.0.1");
    builder.environment().put("ROS_LOG_DIR", folder.toString());
    builder.redirectErrorStream(true).redirectOutput(folder.resolve("ros.txt").toFile());
    return builder;
  }

  @AfterAll
  static void endMaster() {
    if (core != null) {
      core.destroyForcibly();
    }
  }

  @Test
  void aNodeDrivesTheSimulatedRobot() throws Exception {
    try (JavaProcess urbi =
        JavaProcess.start(root, URBI, List.of("-q", "-i", "examples/ros/robot.u"))) {
      urbi.awaitText("The robot is there");
      Process pilot =
          ros("/usr/bin/python3", "examples/ros/drive.py")
              .redirectOutput(ProcessBuilder.Redirect.PIPE)
              .start();
      try {
        seesAndDrives(pilot, "an image of 320 x 240, rgb8, 230400 bytes\n", urbi);
        urbi.awaitText("there is /pilot");
      } finally {
        pilot.destroyForcibly();
      }
      urbi.send("shutdown;\n");
      assertEquals(0, urbi.awaitEnd(), urbi::text);
    }
  }

  /**
   * What the pilot of an example says, to its end.
   *
   * @param before what it says before it tells of the scan
   */
  static void seesAndDrives(Process pilot, String before, JavaProcess urbi) throws IOException {
    String said = new String(pilot.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    String distance = said.replaceAll("(?s).*something at ([\\d.]+) m.*", "$1");
    assertEquals(
        """
        %sa scan of 181 rays, something at %s m
        it went ahead
        it came back
        it stands
        """
            .formatted(before, distance),
        said,
        urbi::text);
    assertTrue(Double.parseDouble(distance) < 4, distance);
  }

  @Test
  void aServerWhoseMasterIsAwayStartsAndFindsItWhenItComes() throws Exception {
    int later = FreePorts.next();
    String uri = "http://127.0.0.1:" + later;
    try (JavaProcess urbi =
        JavaProcess.start(root.with("ROS_MASTER_URI", uri), URBI, List.of("-q", "-i"))) {
      urbi.send("echo(\"it is up\"); echo([\"master\", Ros.checkMaster]);\n");
      urbi.awaitText("it is up");
      urbi.awaitText("ROS: no master at " + uri + ", looking for it every second");
      urbi.awaitText("[\"master\", false]");
      Process late = master(later);
      try {
        urbi.awaitText("ROS: connected to the master " + uri);
        urbi.send("echo([\"master\", Ros.checkMaster]);\nshutdown;\n");
        urbi.awaitText("[\"master\", true]");
        assertEquals(0, urbi.awaitEnd(), urbi::text);
      } finally {
        late.destroyForcibly();
      }
    }
  }
}

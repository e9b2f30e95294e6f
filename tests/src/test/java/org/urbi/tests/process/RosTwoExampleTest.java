package org.urbi.tests.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.tests.process.JavaProcess.Setting;

/** {@code examples/ros}, with nodes of rclpy of two distributions. */
class RosTwoExampleTest {
  private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();

  /** The suites of urbi-ros use lower domains, and the pages those between. */
  private static final String DOMAIN = "100";

  @TempDir static Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"kilted", "jazzy"})
  void aNodeDrivesTheSimulatedRobot(String peers) throws Exception {
    Path python = ROOT.resolve(".build/ros-peers/" + peers + "/bin/python");
    assumeTrue(Files.exists(python), "no ROS 2 for the test: scripts/ros-peers.sh gets it");
    RosExamplesTest.makeModules(folder);
    Setting root =
        Setting.in(ROOT).with("URBI_UOBJECT_PATH", folder.toString()).with("ROS_DOMAIN_ID", DOMAIN);
    try (JavaProcess urbi =
        JavaProcess.start(
            root, RosExamplesTest.URBI, List.of("-q", "-i", "examples/ros/robot.u"))) {
      urbi.awaitText("The robot is there");
      ProcessBuilder builder =
          new ProcessBuilder(python.toString(), "examples/ros/drive_ros2.py")
              .directory(ROOT.toFile())
              .redirectErrorStream(true);
      builder.environment().put("ROS_DOMAIN_ID", DOMAIN);
      builder.environment().put("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST");
      Process pilot = builder.start();
      try {
        RosExamplesTest.seesAndDrives(pilot, "", urbi);
      } finally {
        pilot.destroyForcibly();
      }
      urbi.send("shutdown;\n");
      assertEquals(0, urbi.awaitEnd(), urbi::text);
    }
  }
}

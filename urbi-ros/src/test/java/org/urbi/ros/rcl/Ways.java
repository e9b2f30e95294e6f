package org.urbi.ros.rcl;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import org.urbi.ros.graph.Node;
import org.urbi.ros.rtps.Peer;
import org.urbi.ros.two.TwoSettings;

/** Nodes that go one way or the other. */
public final class Ways {
  private static final Path WITHOUT_SHARED_MEMORY =
      Path.of("../share/ros/without-shared-memory.xml").toAbsolutePath().normalize();

  private Ways() {}

  /** Those of one distribution are all that a process can have. */
  private static Path installed() {
    return Path.of(Peer.prefix(System.getProperty("installed", "kilted")), "installed");
  }

  /** The folder of an installation; whoever has none skips the test. */
  static Path installation() {
    Path folder = installed();
    assumeTrue(
        Files.exists(folder.resolve("lib/librcl.so")),
        "no ROS 2 for the test: scripts/ros-peers.sh gets it");
    return folder;
  }

  /**
   * Starts one.
   *
   * @param way {@code embedded} or {@code rcl}
   * @param people are told what goes wrong
   */
  public static Node start(String way, TwoSettings settings, Consumer<String> people) {
    Map<String, String> environment = new HashMap<>();
    environment.put("URBI_ROS_MIDDLEWARE", way);
    if (way.equals("rcl")) {
      environment.put("AMENT_PREFIX_PATH", installation().toString());
      // On a busy machine, to end a node in shared memory is now and then the end of the process.
      Libraries.environment("FASTDDS_DEFAULT_PROFILES_FILE", WITHOUT_SHARED_MEMORY.toString());
      Libraries.environment("ROS_AUTOMATIC_DISCOVERY_RANGE", "SYSTEM_DEFAULT");
    }
    return Middleware.start(environment, settings, people);
  }
}

package org.urbi.tests.pages;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.urbi.tests.FreePorts;
import org.urbi.tests.TestTimeout;

/**
 * What pages about ROS speak to: a master of ROS 1 with a talker and turtles, as in its tutorials,
 * by Debian's rospy. In ROS 2 the kernel of the page is alone in its domain.
 */
final class RosPeers implements AutoCloseable {
  private static final Path TESTS = Path.of("../urbi-ros/src/test").toAbsolutePath().normalize();

  /** What begins a session. Whoever can hear the talker has found the master. */
  private static final String ONE =
      """
      requireFile("urbi/ros.u")|;
      Ros.version = 1|; Ros.masterUri = "%s"|; Ros.nodeName = "robot"|; Ros.packagePath = "%s"|;
      {
        var first = Ros.Topic.new("/chatter")|
        first.subscribeAs("std_msgs/String")|
        waituntil (first.onMessage?(var m))|
        first.unsubscribe
      }|;
      """;

  /** It has a server of an action for the clients of the page. */
  private static final String TWO =
      """
      requireFile("urbi/ros.u")|;
      Ros.version = 2|; Ros.domain = %d|; Ros.nodeName = "robot"|; Ros.packagePath = "%s"|;
      var fibonacci = Ros.offerAction("/fibonacci", "test_msgs/Fibonacci", function (var goal)
      {
        var numbers = [0, 1]|
        while (numbers.size <= goal.request["order"])
        {
          numbers << numbers[-1] + numbers[-2]|
          goal << ["sequence" => numbers]|
          sleep(1s)
        }|
        ["sequence" => numbers]
      })|;
      """;

  private final List<Process> processes = new ArrayList<>();
  private final Path folder;
  private final int port;

  private RosPeers(Path folder) throws IOException {
    this.folder = folder;
    port = FreePorts.next();
  }

  /** Whether there is a ROS 1 on this machine. */
  static boolean areInstalled() {
    return Stream.of("rospy", "rosmaster", "std_srvs")
        .allMatch(each -> Files.isDirectory(Path.of("/usr/lib/python3/dist-packages", each)));
  }

  /**
   * Starts all of them, and waits until they are there.
   *
   * @param folder for what they write
   */
  static RosPeers start(Path folder) throws Exception {
    RosPeers peers = new RosPeers(folder);
    try {
      peers.run("/usr/bin/rosmaster", "--core", "-p", String.valueOf(peers.port));
      peers.run("/usr/bin/python3", TESTS.resolve("oracles/talker.py").toString());
      await("ready", peers.run("/usr/bin/python3", TESTS.resolve("oracles/turtle.py").toString()));
      return peers;
    } catch (Exception | Error e) {
      peers.close();
      throw e;
    }
  }

  private Process run(String... command) throws IOException {
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.environment().keySet().removeIf(name -> name.startsWith("ROS_"));
    builder.environment().put("ROS_MASTER_URI", master());
    builder.environment().put("ROS_IP", "127.0.0.1");
    builder.environment().put("ROS_LOG_DIR", folder.toString());
    Process process = builder.start();
    processes.add(process);
    return process;
  }

  private static void await(String wanted, Process process) throws Exception {
    BufferedReader reader = process.inputReader();
    CompletableFuture<Boolean> said =
        CompletableFuture.supplyAsync(() -> reader.lines().anyMatch(wanted::equals));
    assertTrue(
        said.get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS), "a node of rospy has begun");
  }

  private String master() {
    return "http://127.0.0.1:" + port;
  }

  /** What makes a session one with these peers. */
  String inOne() {
    return ONE.formatted(master(), TESTS.resolve("oracles/share"));
  }

  /**
   * What makes a session one of ROS 2. The suites of urbi-ros use lower domains, and higher ones
   * would have ports that the system gives to anybody.
   */
  static String inTwo() {
    int domain = 96 + ThreadLocalRandom.current().nextInt(4);
    return TWO.formatted(domain, TESTS.resolve("resources/org/urbi/ros"));
  }

  @Override
  public void close() {
    processes.forEach(Process::destroyForcibly);
    processes.forEach(process -> process.onExit().join());
  }
}

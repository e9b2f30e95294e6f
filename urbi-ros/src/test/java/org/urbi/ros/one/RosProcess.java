package org.urbi.ros.one;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.urbi.ros.Lines;

/** A program of ROS 1, as Debian has it, with an environment of its own. */
public final class RosProcess implements AutoCloseable {
  private static final List<String> WANTED =
      List.of("rosmaster", "roscore", "rosservice", "rostopic", "rosparam");

  private final Process process;
  private final Lines output;

  private RosProcess(Process process) {
    this.process = process;
    this.output = new Lines(process.inputReader(StandardCharsets.UTF_8));
  }

  /** Whether there is a ROS 1 on this machine, with rospy. */
  public static boolean isInstalled() {
    return WANTED.stream().allMatch(each -> Files.isExecutable(Path.of("/usr/bin", each)))
        && Stream.of("rospy", "sensor_msgs", "std_srvs")
            .allMatch(each -> Files.isDirectory(Path.of("/usr/lib/python3/dist-packages", each)));
  }

  /** The environment of all programs that have that master. */
  public static Map<String, String> environment(int port) {
    return Map.of("ROS_MASTER_URI", "http://127.0.0.1:" + port, "ROS_IP", "127.0.0.1");
  }

  /** Starts a program. */
  public static RosProcess start(int port, Path logs, String... command) throws IOException {
    List<String> words = new ArrayList<>(List.of(command));
    words.set(
        0, words.getFirst().startsWith("/") ? words.getFirst() : "/usr/bin/" + words.getFirst());
    ProcessBuilder builder = new ProcessBuilder(words);
    builder.environment().keySet().removeIf(name -> name.startsWith("ROS_"));
    builder.environment().putAll(environment(port));
    builder.environment().put("ROS_LOG_DIR", logs.toString());
    builder.environment().put("ROS_PACKAGE_PATH", "/usr/share");
    builder.environment().put("PATH", "/usr/bin:/bin");
    builder.redirectErrorStream(true);
    return new RosProcess(builder.start());
  }

  /** Starts a master. */
  static RosProcess master(int port, Path logs) throws IOException {
    return start(port, logs, "rosmaster", "--core", "-p", String.valueOf(port));
  }

  /** Its next line is that one; if it is another, the failure has all that it printed. */
  void says(String expected) throws InterruptedException {
    output.says(expected);
  }

  /** Waits for a line that begins so. */
  public void await(String beginning) throws InterruptedException {
    output.await(beginning);
  }

  /** All that it prints until it ends. */
  String all() throws InterruptedException {
    return String.join("\n", output.rest());
  }

  /** Ends it at once. */
  @Override
  public void close() throws IOException {
    process.descendants().forEach(ProcessHandle::destroyForcibly);
    process.destroyForcibly();
    try {
      process.waitFor(10, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}

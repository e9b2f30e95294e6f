package org.urbi.ros.rtps;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.urbi.ros.Lines;

/** A program of somebody else's that speaks the same protocol. */
public final class Peer implements AutoCloseable {
  private static final Path MADE = Path.of("../.build/ros-peers").toAbsolutePath().normalize();
  private static final String LOOPBACK =
      "<CycloneDDS><Domain><General><Interfaces><NetworkInterface name=\"lo\" multicast=\"true\"/>"
          + "</Interfaces></General></Domain></CycloneDDS>";

  private final ProcessHandle process;
  private final Lines answers;
  private final Writer commands;

  /** Starts one of them in that domain; whoever does not have them skips the test. */
  public Peer(String environment, int domain) throws IOException {
    this(environment, domain, script(environment), Map.of());
  }

  /** One that runs another script. */
  public static Peer of(String environment, int domain, String script) throws IOException {
    return new Peer(environment, domain, script, Map.of());
  }

  private static String script(String environment) {
    return environment.equals("cyclone") ? "cyclone.py" : "ros.py";
  }

  /** One of ROS that others miss soon after it has died. */
  public static Peer ofShortLease(String environment, int domain) throws IOException {
    return ofShortLease(environment, domain, script(environment));
  }

  /** One of ROS that others miss soon after it has died, with another script. */
  public static Peer ofShortLease(String environment, int domain, String script)
      throws IOException {
    String profile = resource("short-lease.xml").toString();
    return new Peer(
        environment,
        domain,
        script,
        Map.of(
            "FASTDDS_DEFAULT_PROFILES_FILE", profile,
            "FASTRTPS_DEFAULT_PROFILES_FILE", profile));
  }

  private static Path resource(String name) {
    return Path.of("src/test/resources/peers").resolve(name).toAbsolutePath();
  }

  /** Whoever does not have those peers skips the test. Returns the Python that runs them. */
  static Path assumeThere(String environment) {
    Path python = MADE.resolve(environment).resolve("bin/python");
    assumeTrue(
        Files.exists(python), "no peer for the test: scripts/ros-peers.sh gets " + environment);
    return python;
  }

  private Peer(String environment, int domain, String script, Map<String, String> settings)
      throws IOException {
    Path python = assumeThere(environment);
    Map<String, String> environs = new HashMap<>(settings);
    environs.put("ROS_DOMAIN_ID", Integer.toString(domain));
    environs.put("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST");
    environs.put("CYCLONEDDS_URI", LOOPBACK);
    // There are few of Cyclone DDS, and they begin soon.
    if (environment.equals("cyclone")) {
      ProcessBuilder builder = new ProcessBuilder(python.toString(), resource(script).toString());
      builder.environment().putAll(environs);
      Process started = builder.redirectError(ProcessBuilder.Redirect.INHERIT).start();
      process = started.toHandle();
      answers = new Lines(started.inputReader());
      commands = started.outputWriter();
    } else {
      Nursery.Child child =
          Nursery.of(python, resource("nursery.py")).fork(resource(script), environs);
      process = child.process();
      answers = new Lines(new BufferedReader(new InputStreamReader(child.output(), UTF_8)));
      commands = new OutputStreamWriter(child.input(), UTF_8);
    }
  }

  public void say(String command) throws IOException {
    commands.write(command + "\n");
    commands.flush();
  }

  /** Where its types are defined. */
  public static String prefix(String environment) {
    return MADE.resolve(environment).toString();
  }

  public void expect(String answer) throws InterruptedException {
    answers.says(answer);
  }

  public void expectInAnyOrder(String... expected) throws InterruptedException {
    List<String> seen = new ArrayList<>();
    for (int i = 0; i < expected.length; i++) {
      seen.add(answers.next());
    }
    assertEquals(Stream.of(expected).sorted().toList(), seen.stream().sorted().toList());
  }

  /** Ends it without a word. */
  public void kill() throws InterruptedException {
    process.destroyForcibly();
    answers.rest();
  }

  @Override
  public void close() throws Exception {
    commands.close();
    // One that is in the middle of something does not end by itself.
    if (!answers.endWithin(10, TimeUnit.SECONDS)) kill();
  }
}

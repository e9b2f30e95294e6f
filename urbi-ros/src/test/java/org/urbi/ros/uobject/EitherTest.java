package org.urbi.ros.uobject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.ros.Awaited;
import org.urbi.ros.FreePorts;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.one.RosProcess;
import org.urbi.ros.rtps.Neighbourhood;
import org.urbi.ros.rtps.Peer;

/** A script that only uses topics and services says the same with ROS 1 and ROS 2. */
class EitherTest extends ScriptsFixture {
  private static final Path ORACLES = Path.of("src/test/oracles").toAbsolutePath();

  private static final List<String> SAID =
      List.of(
          "true",
          "true",
          "[\"/peer\"]",
          "[\"/peer\"]",
          "/chatter",
          "[\"data\" => \"\"]",
          "[\"data\" => \"hello\"]",
          "[\"data\" => \"hello\"]",
          "[\"data\" => \"kept\"]",
          "/peer listens",
          "1",
          "[\"data\" => \"to and fro\"]",
          "nothing else for a while",
          "by a variable",
          "data: a string expected, not 1",
          "/echo_in is advertised already: unadvertise first",
          "there is no topic /no_such: Ros.topics has all",
          "there is no topic /no_such: Ros.topics has all",
          "has no such field: size",
          "ranges[3]: this message has none: [3]",
          "rate: times a second expected, or 0 for no limit, not -1.0",
          "there is no service /no_such: Ros.services has all",
          "[\"nanosec\" => 0, \"sec\" => 0]",
          "[\"nanosec\" => 500, \"sec\" => 12]",
          "nothing more in time",
          "true",
          "/increment",
          "true",
          "[42, \"forty!\"]",
          "/ours",
          "well",
          "/ours is offered by this node already",
          "came and went",
          "done");

  private final BlockingQueue<String> output = new LinkedBlockingQueue<>();

  private Kernel kernel() {
    return Kernel.builder()
        .searchPath(List.of(Path.of("../share")))
        .moduleSearchPath(List.of(folder))
        .output(output::add)
        .start();
  }

  private List<String> echoed() throws InterruptedException {
    List<String> lines = new ArrayList<>();
    while (lines.isEmpty() || !lines.getLast().equals("done")) {
      String text = Awaited.next(output, lines);
      if (text.contains("!!!")) {
        throw new AssertionError(lines + " " + text);
      }
      text.lines()
          .filter(line -> line.contains("*** "))
          .forEach(line -> lines.add(line.substring(line.indexOf("*** ") + 4).strip()));
    }
    return lines;
  }

  private void runs(String settings) throws Exception {
    try (Kernel kernel = kernel()) {
      kernel.eval("requireFile(\"urbi/ros.u\");" + settings);
      kernel.eval(Files.readString(ORACLES.resolve("either.u")));
      List<String> lines = echoed();
      assertEquals(SAID.size(), lines.size(), lines::toString);
      for (int i = 0; i < lines.size(); i++) {
        String line = lines.get(i);
        // What is refused says first who has refused it.
        assertTrue(line.endsWith(SAID.get(i)), line);
      }
    }
  }

  @Test
  void withRosOne() throws Exception {
    assumeTrue(RosProcess.isInstalled(), "there is no ROS 1 on this machine");
    int port = FreePorts.next();
    Path types = Path.of("src/test/resources/org/urbi/ros/share").toAbsolutePath();
    try (RosProcess core = RosProcess.start(port, folder, "roscore", "-p", "" + port)) {
      core.await("started core service [/rosout]");
      String script = ORACLES.resolve("pair.py").toString();
      try (RosProcess peer = RosProcess.start(port, folder, "/usr/bin/python3", script)) {
        peer.await("ready");
        runs(
            "Ros.version = 1; Ros.masterUri = \"http://127.0.0.1:%d\"; Ros.packagePath = \"%s\";"
                .formatted(port, types));
      }
    }
  }

  private static String two(Neighbourhood domain, String prefix) {
    return "Ros.version = 2; Ros.domain = %d; Ros.packagePath = \"%s\";"
        .formatted(domain.domain(), prefix);
  }

  @ParameterizedTest
  @ValueSource(strings = {"kilted", "jazzy"})
  void withRosTwo(String environment) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = new Peer(environment, domain.domain())) {
      peer.say("pair");
      peer.expect("ready");
      runs(two(domain, Peer.prefix(environment)));
      peer.kill();
    }
  }

  @Test
  void whatIsWrongIsTold() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Kernel kernel = kernel()) {
      kernel.eval("requireFile(\"urbi/ros.u\");");
      kernel.eval("var Global.before = Ros.version|; Ros.version = 3;");
      assertTrue(kernel.eval("Ros.version == before", boolean.class));
      kernel.eval(two(domain, ""));
      assertEquals("2.0", String.valueOf(kernel.eval("Ros.version;")));
      assertTrue(kernel.eval("Ros.checkMaster", boolean.class));
      refused(kernel, "Ros.getParam(\"x\");", "there is no parameter x");
      kernel.eval("var Global.t = Ros.Topic.new(\"/t\")|;");
      refused(kernel, "t.qos = [\"speed\" => 1]| t.advertise(\"std_msgs/Empty\");", "not 'speed'");
      refused(
          kernel,
          "t.qos = [\"durability\" => \"long\"]| t.advertise(\"std_msgs/Empty\");",
          "qos: durability: \"volatile\" or \"transient_local\" expected");
      refused(kernel, "t.qos = 1| t.advertise(\"std_msgs/Empty\");", "qos: a Dictionary expected");
      refused(kernel, "t.qos = [=>]| t.advertise(\"std_msgs/Nothing\");", "there is no type");
      kernel.eval(
          """
          var Global.never = Ros.offer("/never", "std_srvs/Empty", function (var asked)
          {
            sleep(inf)
          })|;
          var Global.asks = Ros.Service.new("/never", true)|;
          asks.patience = 200ms|;
          """);
      refused(kernel, "asks.request([=>]);", "/never has not answered within 200 ms");
      refused(kernel, "asks.patience = 0| asks.request([=>]);", "patience: seconds, more than 0");
      kernel.eval("var Global.bridge = Ros.Bridge.new|;");
      refused(kernel, "bridge.listen(70000);", "port: 0 to 65535 expected");
      refused(kernel, "bridge.host = \"0.0.0.0\"| bridge.listen(0);", "set a token");
      refused(kernel, "bridge.token = \"brief\"| bridge.listen(0);", "16 characters at least");
      refused(kernel, "bridge.origins = 1| bridge.listen(0);", "origins: a List expected");
      kernel.eval("bridge.host = \"localhost\"| bridge.token = \"\"| bridge.origins = [];");
      assertTrue(kernel.eval("bridge.listen(0) > 0", boolean.class));
      refused(kernel, "bridge.listen(0);", "listens already");
      kernel.eval("bridge.close;");
      assertTrue(kernel.eval("bridge.port == 0 && bridge.clients == 0", boolean.class));
      kernel.eval("Ros.version = 1;");
      assertEquals("2.0", String.valueOf(kernel.eval("Ros.version;")));
    }
  }

  private static void refused(Kernel kernel, String code, String message) {
    String text = assertThrows(UrbiError.class, () -> kernel.eval(code)).getMessage();
    assertTrue(text.contains(message), text);
  }

  @Test
  void whichRosIsMeant() {
    assertEquals(Dialect.ROS_1, RosVersion.of(Map.of()));
    assertEquals(Dialect.ROS_1, RosVersion.of(Map.of("ROS_DISTRO", "noetic")));
    assertEquals(Dialect.ROS_2, RosVersion.of(Map.of("ROS_DISTRO", "jazzy")));
    assertEquals(Dialect.ROS_2, RosVersion.of(Map.of("ROS_VERSION", "2")));
    assertEquals(Dialect.ROS_2, RosVersion.of(Map.of("ROS_DOMAIN_ID", "0")));
    assertEquals(Dialect.ROS_2, RosVersion.of(Map.of("AMENT_PREFIX_PATH", "/opt/ros/kilted")));
    Map<String, String> both = Map.of("ROS_MASTER_URI", "http://x:1", "ROS_DOMAIN_ID", "3");
    assertEquals(Dialect.ROS_1, RosVersion.of(both));
    assertEquals(
        Dialect.ROS_2,
        RosVersion.of(Map.of("ROS_MASTER_URI", "http://x:1", "URBI_ROS_VERSION", "2")));
    assertThrows(RosException.class, () -> RosVersion.of(Map.of("URBI_ROS_VERSION", "two")));
  }
}

package org.urbi.ros.uobject;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.ros.Awaited;
import org.urbi.ros.FreePorts;
import org.urbi.ros.one.RosProcess;

/**
 * The dialogues of the manual ("Urbi for ROS users", "Communication with ROS") with Debian's
 * roscore, and nodes of rospy.
 */
class ManualTest {
  @TempDir static Path folder;
  private static int port;
  private static RosProcess core;
  private static RosProcess turtle;
  private static RosProcess talker;

  private final BlockingQueue<String> output = new LinkedBlockingQueue<>();
  private Kernel kernel;

  @BeforeAll
  static void startRos() throws Exception {
    RosJar.writeTo(folder);
    assumeTrue(RosProcess.isInstalled(), "there is no ROS 1 on this machine");
    port = FreePorts.next();
    core = RosProcess.start(port, folder, "roscore", "-p", String.valueOf(port));
    core.await("started core service [/rosout]");
    turtle = python("turtle.py");
    turtle.await("ready");
    talker = python("talker.py");
  }

  private static RosProcess python(String file) throws IOException {
    Path script = Path.of("src/test/oracles").resolve(file).toAbsolutePath();
    return RosProcess.start(port, folder, "/usr/bin/python3", script.toString());
  }

  @AfterAll
  static void endRos() throws IOException {
    for (RosProcess each : new RosProcess[] {talker, turtle, core}) {
      if (each != null) {
        each.close();
      }
    }
  }

  @BeforeEach
  void start() {
    kernel =
        Kernel.builder()
            .searchPath(List.of(Path.of("../share")))
            .moduleSearchPath(List.of(folder))
            .output(text -> text.lines().forEach(output::add))
            .start();
    kernel.eval(
        """
        requireFile("urbi/ros.u");
        Ros.masterUri = "http://127.0.0.1:%d";
        Ros.packagePath = "%s";
        """
            .formatted(port, Path.of("src/test/oracles/share").toAbsolutePath()));
  }

  @AfterEach
  void stop() {
    kernel.close();
  }

  private String text(String code) {
    return String.valueOf(kernel.eval(code + ";"));
  }

  private boolean holds(String code) {
    return kernel.eval(code, boolean.class);
  }

  /** The next line that was echoed, without its time. */
  private String echoed() throws InterruptedException {
    String line = Awaited.next(output);
    while (!line.contains("*** ") || line.contains("ROS: ")) {
      line = Awaited.next(output);
    }
    return line.substring(line.indexOf("*** ") + 4).strip();
  }

  private void refused(String code, String message) {
    String text = assertThrows(UrbiError.class, () -> kernel.eval(code)).getMessage();
    assertTrue(text.contains(message), text);
  }

  @Test
  void whoIsThere() {
    assertTrue(holds("Ros.checkMaster"));
    assertEquals("1.0", text("Ros.version"));
    assertTrue(holds("Ros.name[0, 6] == \"/urbi_\""));
    // A node is there before what it publishes.
    kernel.eval(
        """
        while ("/talker" not in Ros.nodes || "/chatter" not in Ros.nodes["/talker"]["publish"])
          sleep(50ms);
        """);
    assertTrue(holds("\"/rosout\" in Ros.nodes"));
    assertEquals("std_msgs/String", text("Ros.topics[\"/chatter\"][\"type\"]"));
    assertEquals("[/turtlesim]", text("Ros.services[\"/spawn\"]"));
    assertTrue(holds("\"/rosout/get_loggers\" in Ros.services"));
    kernel.eval("Ros.Topic.new(\"/any\").advertise(\"std_msgs/Empty\");");
    assertTrue(holds("Ros.name in Ros.nodes"));
    assertTrue(holds("(Ros.name + \"/get_loggers\") in Ros.services"));
    assertTrue(holds("(Ros.name + \"/set_logger_level\") in Ros.services"));
  }

  @Test
  void whatPeopleAreTold() throws InterruptedException {
    kernel.eval(
        """
        var Global.logTopic = Ros.Topic.new("/rosout_agg")|;
        logTopic.subscribe;
        at (logTopic.onMessage?(var m) if m["name"] == Ros.name) echo(m["msg"]);
        var Global.loggers = Ros.Service.new(Ros.name + "/set_logger_level", false)|;
        loggers.request(["logger" => "urbi", "level" => "warn"]);
        var Global.said = Tag.new|;
        said: every (50ms) { Ros.log("info", "not this"); Ros.log("error", "but this") },
        """);
    assertEquals("but this", echoed());
    assertEquals(
        "[file, function, header, level, line, msg, name, topics]",
        text("logTopic.structure.keys.sort"));
    refused("Ros.log(\"loud\", \"x\");", "level: debug, info");
  }

  @Test
  void theChatter() throws InterruptedException {
    kernel.eval(
        """
        var Global.chatter = Ros.Topic.new("/chatter")|;
        chatter.subscribe;
        var Global.chatTag = Tag.new|;
        chatTag: at (chatter.onMessage?(var e)) echo(e);
        """);
    assertTrue(echoed().startsWith("[\"data\" => \"Hello there! This is message ["));
    assertEquals("{data=}", text("chatter.structure"));
    kernel.eval("waituntil (chatter.last.isA(Dictionary)); chatTag.freeze; sleep(200ms);");
    output.clear();
    kernel.eval("sleep(300ms);");
    assertTrue(output.isEmpty(), output::toString);
    kernel.eval("chatTag.unfreeze;");
    echoed();
    kernel.eval("chatter.unsubscribe; chatter.init(\"/other\");");
    assertEquals("/other", text("chatter.name"));
    assertTrue(holds("chatter.structure.isVoid"));
    refused("chatter.subscribe;", "there is no topic /other");
  }

  @Test
  void theTurtle() throws InterruptedException {
    kernel.eval(
        """
        var Global.velocity = Ros.Topic.new("/turtle1/command_velocity")|;
        velocity.advertise("turtlesim/Velocity");
        var Global.pose = Ros.Topic.new("/turtle1/pose")|;
        pose.subscribe;
        while (velocity.subscriberCount == 0) sleep(20ms);
        at (pose.onMessage?(var p) if p["angular_velocity"] > 1.5) echo("fast");
        var Global.m = velocity.structure.new|;
        m["linear"] = 0.8|;
        UVar.new(Global, "angular")|;
        Global.angular = 0|;
        at (Global.angular->changed?)
        {
          m["angular"] = Global.angular;
          velocity << m
        };
        var Global.angTag = Tag.new|;
        angTag: Global.angular = 0.3 sin: 2s ampli: 2,
        """);
    assertEquals("{linear=0.0, angular=0.0}", text("velocity.structure"));
    assertEquals("fast", echoed());
    kernel.eval("angTag.stop;");
    refused("velocity << [\"linear\" => 1];", "angular: this key of turtlesim/Velocity is missing");
    refused("velocity << [\"linear\" => 1, \"angular\" => \"x\"];", "angular: a number expected");
    refused("velocity.subscribe;", "advertised already");
    kernel.eval("velocity.unadvertise;");
    refused("velocity << m;", "not advertised");
    refused("velocity.advertise(\"turtlesim/Speed\");", "there is no type turtlesim/Speed");
    kernel.eval("velocity.advertise(\"\");");
    assertEquals("{linear=0.0, angular=0.0}", text("velocity.structure"));
  }

  @Test
  void jenny() {
    kernel.eval(
        """
        var Global.logger = Regexp.new("(get|set)_logger")|;
        var Global.services = Ros.services.keys.filter(closure (s) { s not in logger })|;
        var Global.spawn = Ros.Service.new("/spawn", true)|;
        waituntil (spawn.initialized);
        var Global.req = spawn.reqStruct.new|;
        req["x"] = 4|
        req["y"] = 4|
        req["name"] = "Jenny"|;
        """);
    assertEquals(
        "[/clear, /kill, /reset, /spawn, /turtle1/set_pen, /turtle1/teleport_absolute,"
            + " /turtle1/teleport_relative]",
        text("services.sort"));
    assertEquals("{name=Jenny}", text("spawn.request(req)"));
    assertEquals("{name=}", text("spawn.resStruct"));
    assertEquals("/spawn", text("spawn.name"));
    refused("spawn.request([\"x\" => 4]);", "y: this key");
    refused("Ros.Service.new(\"/no_such\", false);", "there is no service /no_such");
    refused("Ros.Service.new(\"/no such\", false);", "invalid name");
    assertEquals(
        "true",
        text(
            "var l = Ros.Service.new(\"/rosout/get_loggers\", false)|"
                + " \"level\" in l.request([=>])[\"loggers\"][0]"));
  }

  @Test
  void aPublisherAndASubscriber() throws InterruptedException {
    kernel.eval(
        """
        var Global.publisher = Ros.Topic.new("/example")|
        at (publisher.onConnect?(var name))
          echo(name[0,5] + " is now listening on " + publisher.name);
        at (publisher.onDisconnect?(var name))
          echo(name[0,5] + " is no longer listening on " + publisher.name);
        assert(publisher.structure.isVoid);
        publisher.advertise("std_msgs/String");
        var Global.subscriber = Ros.Topic.new("/example")|
        at (subscriber.onMessage?(var m))
          echo(m["data"]);
        subscriber.subscribe;
        """);
    assertEquals("/urbi is now listening on /example", echoed());
    assertTrue(holds("subscriber.structure == publisher.structure"));
    kernel.eval(
        """
        var message = publisher.structure.new|;
        message["data"] = "Hello world!"|;
        publisher << message;
        """);
    assertEquals("Hello world!", echoed());
    kernel.eval("subscriber.unsubscribe;");
    assertEquals("/urbi is no longer listening on /example", echoed());
  }

  @Test
  void images() throws InterruptedException {
    kernel.eval(
        """
        class Global.camera { UVar.new(this, "val"); val = 0 }|;
        var Global.out = Ros.Topic.new("/camera/image/compressed")|;
        out.latch = 1|;
        out.advertise("sensor_msgs/CompressedImage");
        var rosImg = out.structure.new|;
        var picture = Binary.new("jpeg", "abc")|;
        rosImg["data"] = picture|;
        rosImg["format"] = "jpeg"|;
        out << rosImg;
        var Global.back = Ros.Topic.new("/camera/image/compressed")|;
        at (back.onMessage?(var imgMsg))
        {
          imgMsg["data"].keywords = imgMsg["format"]|
          camera.val = imgMsg["data"]|
          echo(camera.val.keywords + " " + camera.val.data)
        };
        back.subscribe;
        """);
    assertEquals("jpeg abc", echoed());
  }

  @Test
  void aServiceOfUrbiscript() throws Exception {
    kernel.eval(
        """
        var Global.server = Ros.offer("/ours", "std_srvs/SetBool", function (var request)
        {
          if (request["data"])
            throw Exception.new("not now");
          ["success" => true, "message" => "well"]
        })|;
        """);
    try (RosProcess call =
        RosProcess.start(port, folder, "rosservice", "call", "/ours", "data: false")) {
      call.await("success: True");
      call.await("message: \"well\"");
    }
    try (RosProcess call =
        RosProcess.start(port, folder, "rosservice", "call", "/ours", "data: true")) {
      call.await("ERROR: service [/ours] responded with an error: b'not now'");
    }
    // The master is told behind the back of the job.
    kernel.eval("server.close; while (\"/ours\" in Ros.services) sleep(20ms);");
  }

  @Test
  void parameters() {
    kernel.eval("Ros.setParam(\"/tested\", [\"a\" => 1, \"b\" => [\"x\", 0.5]]);");
    assertEquals("{a=1.0, b=[x, 0.5]}", text("Ros.getParam(\"/tested\")"));
    assertTrue(holds("\"/tested/a\" in Ros.params"));
    kernel.eval("Ros.deleteParam(\"/tested\");");
    assertEquals("false", text("Ros.hasParam(\"/tested\")"));
  }

  /** As in ROS 2: the manual has none. */
  @Test
  void actions() throws Exception {
    kernel.eval(
        """
        var Global.server = Ros.offerAction("/counts", "actionlib/Test",
          function (var goal)
          {
            goal << ["feedback" => goal.request["goal"] + 1]|
            if (goal.request["goal"] >= 100)
              sleep(inf)|
            ["result" => goal.request["goal"] + 2]
          },
          function (var request) { request["goal"] >= 0 })|;
        while ("/counts" not in Ros.actions)
          sleep(10ms);
        var Global.counts = Ros.Action.new("/counts")|;
        """);
    assertTrue(holds("counts.goalStruct == [\"goal\" => 0]"));
    assertTrue(holds("counts.run([\"goal\" => 1]) == [\"result\" => 3]"));
    refused("counts.run([\"goal\" => -1]);", "/counts refuses the goal");
    refused("counts.run([\"go\" => 1]);", "goal.goal: this key of actionlib/TestGoal is missing");
    kernel.eval(
        """
        var Global.sent = counts.send(["goal" => 500])|;
        waituntil (!sent.feedback.isVoid);
        assert(sent.feedback == ["feedback" => 501]);
        sent.cancel;
        waituntil (sent.status == "canceled");
        server.close;
        """);
  }
}

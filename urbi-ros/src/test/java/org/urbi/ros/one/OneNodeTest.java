package org.urbi.ros.one;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.ros.Awaited;
import org.urbi.ros.FreePorts;
import org.urbi.ros.Lent;
import org.urbi.ros.frames.FrameBuffer;
import org.urbi.ros.frames.FrameListener;
import org.urbi.ros.frames.Transform;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.ValueException;
import urbi.UBinary;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** A node among those of a real ROS 1: Debian's master, rospy and tools. */
class OneNodeTest {
  @TempDir static Path logs;
  private static int port;
  private static RosProcess master;
  private static RosProcess peer;

  private OneNode node;

  static OneNode node(int port, String name) {
    Map<String, String> environment = new HashMap<>(RosProcess.environment(port));
    environment.put("ROS_NAMESPACE", "/space");
    return OneNode.start(
        OneSettings.of(environment, name, Map.of("before", "/after")), there -> {});
  }

  private static RosProcess peer(int port) throws Exception {
    RosProcess started =
        RosProcess.start(
            port, logs, "/usr/bin/python3", Path.of("src/test/oracles/peer.py").toString());
    started.await("ready");
    return started;
  }

  @BeforeAll
  static void startRos() throws Exception {
    assumeTrue(RosProcess.isInstalled(), "there is no ROS 1 on this machine");
    port = FreePorts.next();
    master = RosProcess.master(port, logs);
    peer = peer(port);
  }

  @AfterAll
  static void endRos() throws IOException {
    if (peer != null) {
      peer.close();
      master.close();
    }
  }

  @BeforeEach
  void startNode() {
    node = node(port, "/tested");
  }

  @AfterEach
  void endNode() {
    if (node != null) {
      node.close();
    }
  }

  private MessageType type(String name) {
    return node.definitions().message(name);
  }

  private Publisher publisher(String topic, String type, Qos qos, BlockingQueue<String> told) {
    return node.advertise(
        topic,
        type(type),
        qos,
        new Publisher.Listener() {
          @Override
          public void connected(String name) {
            told.add("+" + name);
          }

          @Override
          public void disconnected(String name) {
            told.add("-" + name);
          }
        });
  }

  private static UDictionary text(String data) {
    return new UDictionary().with("data", data);
  }

  @Test
  void aTopicIsHeardWithoutItsTypeBeingKnown() throws InterruptedException {
    Heard heard = new Heard();
    try (Subscription chatter = node.subscribe("/chatter", null, Qos.DEFAULT, heard)) {
      assertEquals("std_msgs/msg/String", Awaited.next(heard.types).name().toString());
      assertTrue(heard.text().startsWith("hello "));
      assertEquals(1, chatter.publishers());
    }
    Lent lent = new Lent();
    try (Subscription chatter = node.subscribe("/chatter", null, Qos.DEFAULT, lent)) {
      String hello = lent.next();
      // Their length, "hello ".
      assertTrue(hello.matches("[0-9a-f]{2}00000068656c6c6f20.*"), hello);
      assertFalse(lent.next().isEmpty());
      assertEquals(1, chatter.publishers());
    }
  }

  @Test
  void whatIsSaidComesBack() throws Exception {
    Heard heard = new Heard();
    BlockingQueue<String> told = new LinkedBlockingQueue<>();
    Subscription back = node.subscribe("/echo_out", type("std_msgs/String"), Qos.DEFAULT, heard);
    Publisher out = publisher("/echo_in", "std_msgs/String", Qos.DEFAULT, told);
    assertEquals("+/peer", Awaited.next(told));
    awaitGreeting(heard);
    assertEquals(1, back.publishers());
    assertEquals(1, out.subscribers());
    for (String each : new String[] {"", "äß漢 \"\\\n", "x".repeat(100_000)}) {
      out.publish(text(each));
      assertEquals(each, heard.text());
    }
    assertThrows(ValueException.class, () -> out.publish(new UDictionary().with("date", "")));
    out.close();
    assertThrows(RosException.class, () -> out.publish(text("")));
  }

  /** Waits for the latched message: rospy answers before it counts a subscriber among its own. */
  private static void awaitGreeting(Heard heard) throws InterruptedException {
    Awaited.next(heard.messages, heard.failures);
  }

  @Test
  void images() throws Exception {
    Heard heard = new Heard();
    BlockingQueue<String> told = new LinkedBlockingQueue<>();
    node.subscribe("/image_size", type("std_msgs/UInt32"), Qos.DEFAULT, heard);
    Publisher out = publisher("/image_in", "sensor_msgs/Image", Qos.DEFAULT, told);
    Awaited.next(told);
    awaitGreeting(heard);
    UDictionary image = Templates.of(out.type());
    byte[] data = new byte[64 * 48 * 3];
    data[5] = 7;
    image.put("data", new UValue(new UBinary(data)));
    out.publish(image);
    assertEquals(data.length + 7, Awaited.next(heard.messages).get("data").intValue());
  }

  /** As those of rospy and roscpp, whatever the program has said. */
  @Test
  void whatBeginsWithAHeaderIsNumbered() throws Exception {
    Heard heard = new Heard();
    BlockingQueue<String> told = new LinkedBlockingQueue<>();
    node.subscribe("/image_number", type("std_msgs/UInt32"), Qos.DEFAULT, heard);
    Publisher out = publisher("/image_in", "sensor_msgs/Image", Qos.DEFAULT, told);
    Awaited.next(told);
    awaitGreeting(heard);
    for (int number = 1; number <= 3; number++) {
      out.publish(Templates.of(out.type()));
      assertEquals(number, Awaited.next(heard.messages).get("data").intValue());
    }
  }

  @Test
  void latchedMessagesAreForThoseWhoComeLater() throws IOException, InterruptedException {
    Heard heard = new Heard();
    node.subscribe("/latched", null, Qos.DEFAULT, heard);
    assertEquals("kept", heard.text());
    publisher("ours", "std_msgs/String", Qos.LATCHED, new LinkedBlockingQueue<>())
        .publish(text("kept as well"));
    try (RosProcess echo = RosProcess.start(port, logs, "rostopic", "echo", "-n1", "/space/ours")) {
      assertEquals("data: \"kept as well\"", echo.all().lines().findFirst().orElse(""));
    }
  }

  @Test
  void namesAreRemapped() {
    assertEquals(
        "/after",
        publisher("before", "std_msgs/String", Qos.DEFAULT, new LinkedBlockingQueue<>()).topic());
    assertEquals(
        "/tested/own",
        publisher("~own", "std_msgs/String", Qos.DEFAULT, new LinkedBlockingQueue<>()).topic());
    for (String bad : new String[] {"", "/", "a b", "é", "a-b", "9"}) {
      assertThrows(
          RosException.class, () -> node.subscribe(bad, null, Qos.DEFAULT, new Heard()), bad);
    }
  }

  @Test
  void anotherVersionOfATypeIsTold() throws InterruptedException {
    Heard heard = new Heard();
    node.subscribe("/chatter", type("std_msgs/Int32"), Qos.DEFAULT, heard);
    String reason = Awaited.next(heard.failures);
    assertTrue(reason.contains("std_msgs/Int32"), reason);
    assertTrue(heard.messages.isEmpty());
    Publisher wrong =
        publisher("/wrong", "std_msgs/Int32", Qos.DEFAULT, new LinkedBlockingQueue<>());
    assertThrows(
        RosException.class,
        () -> publisher("/wrong", "std_msgs/String", Qos.DEFAULT, new LinkedBlockingQueue<>()));
    Heard own = new Heard();
    node.subscribe(wrong.topic(), type("std_msgs/String"), Qos.DEFAULT, own);
    assertTrue(Awaited.next(own.failures).contains("std_msgs/Int32"));
  }

  @Test
  void servicesOfOthers() throws Exception {
    for (boolean keepAlive : new boolean[] {false, true}) {
      ServiceClient client = node.client("/set_bool", null, keepAlive).get();
      for (int i = 0; i < 3; i++) {
        UDictionary answer = client.request(new UDictionary().with("data", true)).get();
        assertEquals("got True", answer.get("message").stringValue());
      }
      ServiceClient failing = node.client("/failing", null, keepAlive).get();
      for (int i = 0; i < 2; i++) {
        CompletionException refused =
            assertThrows(
                CompletionException.class, () -> Awaited.value(failing.request(new UDictionary())));
        assertTrue(refused.getCause().getMessage().contains("no luck"), refused.getMessage());
      }
    }
    CompletionException none =
        assertThrows(
            CompletionException.class, () -> Awaited.value(node.client("/no_such", null, false)));
    assertTrue(none.getCause() instanceof RosException, none.getMessage());
  }

  @Test
  void servicesOfOurs() throws Exception {
    node.serve(
        "/ours",
        node.definitions().service("std_srvs/SetBool"),
        request ->
            CompletableFuture.completedFuture(
                new UDictionary().with("success", request.get("data")).with("message", "well")));
    node.serve(
        "/broken",
        node.definitions().service("std_srvs/Trigger"),
        request -> CompletableFuture.failedFuture(new RosException("out of order")));
    awaitService("/broken");
    try (RosProcess call =
            RosProcess.start(port, logs, "rosservice", "call", "/ours", "data: true");
        RosProcess broken = RosProcess.start(port, logs, "rosservice", "call", "/broken")) {
      assertEquals("success: True\nmessage: \"well\"", call.all());
      String told = broken.all();
      assertTrue(told.contains("out of order"), told);
    }
    ServiceClient own = node.client("/ours", null, true).get();
    assertEquals(
        "well", own.request(new UDictionary().with("data", 0)).get().get("message").stringValue());
  }

  private void awaitService(String name) throws Exception {
    Awaited.until(name, () -> node.graph().get().services().containsKey(name));
  }

  @Test
  void whoDoesWhat() throws Exception {
    node.subscribe("/chatter", null, Qos.DEFAULT, new Heard());
    BlockingQueue<GraphSnapshot> seen = new LinkedBlockingQueue<>();
    Runnable end = node.watch(seen::add);
    GraphSnapshot graph = Awaited.next(seen);
    while (!graph.nodes().containsKey("/tested")) {
      graph = Awaited.next(seen);
    }
    end.run();
    assertTrue(graph.nodes().get("/peer").publishes().contains("/chatter"));
    assertTrue(graph.nodes().get("/tested").subscribes().contains("/chatter"));
    assertEquals("std_msgs/String", graph.topics().get("/chatter").type());
    assertTrue(graph.services().get("/set_bool").providers().contains("/peer"));
    assertTrue(node.reachable().get());
  }

  @Test
  void theTimeOfOthers() throws Exception {
    Publisher clock =
        publisher(
            "/clock",
            "rosgraph_msgs/Clock",
            new Qos(true, true, 1, Qos.DEFAULT.deadline(), false),
            new LinkedBlockingQueue<>());
    clock.publish(new UDictionary().with("clock", Templates.instant(42, 500)));
    assertTrue(node.now() > 1e18, "years after 1970");
    node.parameters().set("/use_sim_time", new UValue(true)).get();
    Awaited.until("the time", () -> node.now() == 42_000_000_500L);
    node.parameters().set("/use_sim_time", new UValue(false)).get();
    assertTrue(node.now() > 1e18);
    node.parameters().set("/use_sim_time", new UValue(true)).get();
    Awaited.until("the time", () -> node.now() == 42_000_000_500L);
    node.parameters().delete("/use_sim_time").get();
    assertTrue(node.now() > 1e18, "the parameter is not there any more");
    node.parameters().set("/use_sim_time", new UValue(true)).get();
    Awaited.until("the time", () -> node.now() == 42_000_000_500L);
    try (RosProcess other = RosProcess.start(port, logs, "rosparam", "delete", "/use_sim_time")) {
      assertEquals("", other.all());
    }
    Awaited.until("the time of people", () -> node.now() > 1e18);
  }

  @Test
  void theFramesOfOthers() throws Exception {
    Publisher frames =
        publisher("/tf_static", "tf2_msgs/TFMessage", Qos.LATCHED, new LinkedBlockingQueue<>());
    UDictionary stamped = Templates.of(type("geometry_msgs/TransformStamped"));
    stamped.get("header").udictionaryValue().put("frame_id", "/base");
    stamped.put("child_frame_id", "laser");
    UDictionary transform = stamped.get("transform").udictionaryValue();
    transform.get("translation").udictionaryValue().put("x", 0.5);
    transform.get("rotation").udictionaryValue().put("w", 1);
    frames.publish(new UDictionary().with("transforms", UList.of(stamped)));
    FrameListener listener = new FrameListener(node, text -> {});
    Transform found =
        listener.lookup("base", "laser", FrameBuffer.NEWEST, 60_000).get().transform();
    assertEquals(0.5, found.x());
  }

  @Test
  void parametersAreShared() throws Exception {
    Parameters parameters = node.parameters();
    BlockingQueue<UValue> seen = new LinkedBlockingQueue<>();
    parameters.watch("/shared", seen::add);
    UValue value =
        UValue.parse("[\"n\" => 5, \"x\" => 0.5, \"s\" => \"a<&\\\"b\", \"l\" => [1, \"2\"]]");
    parameters.set("/shared", value).get();
    assertEquals(value, parameters.get("/shared").get());
    UValue told = Awaited.next(seen);
    while (!told.equals(value)) {
      told = Awaited.next(seen);
    }
    try (RosProcess get = RosProcess.start(port, logs, "rosparam", "get", "/shared/s")) {
      assertEquals("a<&\"b", get.all());
    }
    assertTrue(parameters.names().get().contains("/shared/x"));
    parameters.delete("/shared").get();
    assertEquals(false, parameters.has("/shared").get());
    assertThrows(CompletionException.class, () -> Awaited.value(parameters.get("/shared")));
  }
}

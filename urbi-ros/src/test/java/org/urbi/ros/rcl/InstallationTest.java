package org.urbi.ros.rcl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.foreign.MemorySegment;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.ros.Awaited;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.rtps.Neighbourhood;
import org.urbi.ros.two.TwoNode;
import org.urbi.ros.two.TwoSettings;
import urbi.UDictionary;
import urbi.thread.GuardedThreads;

/** An installed ROS 2 that is not as it should be, and what is left when its nodes are closed. */
class InstallationTest {
  private final BlockingQueue<String> told = new LinkedBlockingQueue<>();
  @TempDir Path folder;

  private static TwoSettings settings(int domain, String name) {
    return TwoSettings.of(Map.of("ROS_DOMAIN_ID", "" + domain), name, Map.of());
  }

  private Path library() throws Exception {
    return Files.createDirectories(folder.resolve("lib")).resolve("librcl.so");
  }

  /** Why there is no node of the installation, when that is asked for. */
  private String refusal(String name, String value) {
    RosException refused =
        assertThrows(
            RosException.class,
            () ->
                Middleware.start(
                    Map.of(name, value, "AMENT_PREFIX_PATH", "/nowhere:" + folder),
                    settings(0, "node"),
                    told::add));
    return refused.getMessage();
  }

  /** The threads of the middleware have been in Java code: nobody waits for them in vain. */
  @Test
  void aProgramMayEndWithoutClosingItsNode() throws Exception {
    Path installation = Ways.installation();
    try (Neighbourhood domain = new Neighbourhood();
        TwoNode other = TwoNode.start(settings(domain.domain(), "other"), told::add)) {
      MessageType type = other.definitions().message("std_msgs/String");
      other
          .advertise("x", type, Qos.LATCHED, new Publisher.Listener() {})
          .publish(Templates.of(type).with("data", "heard"));
      Process program =
          new ProcessBuilder(
                  ProcessHandle.current().info().command().orElseThrow(),
                  "--enable-native-access=ALL-UNNAMED",
                  "-cp",
                  System.getProperty("java.class.path"),
                  EndsWithoutClosing.class.getName(),
                  "" + domain.domain(),
                  installation.toAbsolutePath().toString())
              .inheritIO()
              .start();
      try {
        assertEquals(7, Awaited.value(program.onExit()).exitValue());
      } finally {
        program.destroyForcibly();
      }
    }
  }

  @Test
  void whatIsNotInstalledIsNotUsed() throws Exception {
    String source =
        "no folder of AMENT_PREFIX_PATH has lib/librcl.so: source a ROS 2,"
            + " or set URBI_ROS_MIDDLEWARE=embedded";
    assertEquals(
        "URBI_ROS_MIDDLEWARE is rcl, but " + source, refusal("URBI_ROS_MIDDLEWARE", "rcl"));
    // Nobody who wants security speaks without it.
    assertEquals(
        "ROS_SECURITY_ENABLE is true, but " + source, refusal("ROS_SECURITY_ENABLE", "true"));
    assertEquals(
        "URBI_ROS_MIDDLEWARE is embedded or rcl, and is 'dds'",
        refusal("URBI_ROS_MIDDLEWARE", "dds"));
    try (Neighbourhood domain = new Neighbourhood();
        Node ours = usual(domain, "rmw_cyclonedds_cpp");
        Node other = usual(domain, "rmw_zenoh_cpp")) {
      assertInstanceOf(TwoNode.class, ours);
      assertInstanceOf(TwoNode.class, other);
      assertEquals(
          "RMW_IMPLEMENTATION is rmw_zenoh_cpp, but "
              + source
              + "; until then, only nodes with DDS are reached",
          told.poll());
      assertTrue(told.isEmpty(), told::toString);
    }
  }

  private Node usual(Neighbourhood domain, String implementation) {
    return Middleware.start(
        Map.of("RMW_IMPLEMENTATION", implementation), settings(domain.domain(), "node"), told::add);
  }

  @Test
  void whatIsBrokenIsNamed() throws Exception {
    Files.writeString(library(), "not a library");
    String text = refusal("URBI_ROS_MIDDLEWARE", "rcl");
    assertTrue(
        text.startsWith("URBI_ROS_MIDDLEWARE is rcl, but " + library() + " cannot be loaded: "),
        text);
  }

  @Test
  void anOldOneIsNamed() throws Exception {
    Files.copy(Ways.installation().resolve("lib/librcutils.so"), library());
    String text = refusal("URBI_ROS_MIDDLEWARE", "rcl");
    assertTrue(text.contains("librcl.so is older than ROS 2 Iron"), text);
  }

  @Test
  void whatDoesNotEndIsTold() {
    Installation installation =
        Installation.of(Map.of("AMENT_PREFIX_PATH", Ways.installation().toString())).orElseThrow();
    installation.load();
    installation
        .functions()
        .end(trouble -> told.add(trouble.getMessage()), "rcl_node_fini", MemorySegment.NULL);
    String text = String.valueOf(told.poll());
    assertTrue(text.startsWith("rcl_node_fini: ") && text.length() > 20, text);
  }

  @Test
  void typesThatAreNotInstalled() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node node = Ways.start("rcl", settings(domain.domain(), "node"), told::add)) {
      MessageType frames = node.definitions().message("tf2_msgs/TFMessage");
      RosException missing =
          assertThrows(
              RosException.class,
              () -> node.subscribe("frames", frames, Qos.DEFAULT, message -> {}));
      assertEquals(
          "the installed ROS 2 has nothing of the package tf2_msgs: build it there,"
              + " or set URBI_ROS_MIDDLEWARE=embedded",
          missing.getMessage());
      // Others go on.
      MessageType string = node.definitions().message("std_msgs/String");
      node.subscribe("text", string, Qos.DEFAULT, message -> {}).close();
    }
  }

  @Test
  void typesAreLoadedBeforeTheyAreUsed() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node node = Ways.start("rcl", settings(domain.domain(), "node"), told::add)) {
      MessageType text = node.definitions().message("std_msgs/String");
      Awaited.value(node.prepared(text));
      assertTrue(node.prepared(text).isDone());
      node.subscribe("text", text, Qos.DEFAULT, message -> {}).close();
      MessageType frames = node.definitions().message("tf2_msgs/TFMessage");
      CompletionException missing =
          assertThrows(CompletionException.class, () -> Awaited.value(node.prepared(frames)));
      assertInstanceOf(RosException.class, missing.getCause());
      assertTrue(missing.getCause().getMessage().contains("nothing of the package tf2_msgs"));
    }
  }

  @Test
  void memoryIsSharedWithNobodyIfAProfileSaysSo() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node one = Ways.start("rcl", settings(domain.domain(), "one"), told::add);
        Node two = Ways.start("rcl", settings(domain.domain(), "two"), told::add)) {
      MessageType text = one.definitions().message("std_msgs/String");
      BlockingQueue<UDictionary> heard = new LinkedBlockingQueue<>();
      two.subscribe("x", text, Qos.LATCHED, heard::add);
      one.advertise("x", text, Qos.LATCHED, new Publisher.Listener() {})
          .publish(Templates.of(text));
      Awaited.next(heard, told);
      String maps = Files.readString(Path.of("/proc/self/maps"));
      assertFalse(maps.contains("/dev/shm/fast"), maps);
    }
  }

  /** {@code rcl} keeps the types of a node's parts where only one thread may be. */
  @Test
  void partsAreMadeOneAfterTheOther() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node node = Ways.start("rcl", settings(domain.domain(), "node"), told::add)) {
      MessageType text = node.definitions().message("std_msgs/String");
      CountDownLatch made = new CountDownLatch(1);
      Thread second =
          GuardedThreads.SDK.platform(
              "second",
              () -> {
                node.subscribe("x", text, Qos.DEFAULT, message -> {}).close();
                made.countDown();
              });
      ((RclNode) node)
          .session()
          .change(() -> {
            second.start();
            while (second.isAlive() && second.getState() != Thread.State.WAITING)
              Thread.onSpinWait();
            assertEquals(1, made.getCount());
          });
      Awaited.zero(made, "the second part");
    }
  }

  @Test
  void nothingIsHeardAfterItWasClosed() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node other = TwoNode.start(settings(domain.domain(), "other"), told::add)) {
      MessageType string = other.definitions().message("std_msgs/String");
      BlockingQueue<String> connected = new LinkedBlockingQueue<>();
      Publisher publisher =
          other.advertise(
              "x",
              string,
              Qos.DEFAULT,
              new Publisher.Listener() {
                @Override
                public void connected(String node) {
                  connected.add(node);
                }
              });
      UDictionary message = Templates.of(string).with("data", "hello");
      for (int i = 0; i < 3; i++) {
        BlockingQueue<UDictionary> heard = new LinkedBlockingQueue<>();
        Node node = Ways.start("rcl", settings(domain.domain(), "node" + i), told::add);
        Subscription subscription = node.subscribe("x", string, Qos.DEFAULT, heard::add);
        Publisher own = node.advertise("y", string, Qos.DEFAULT, new Publisher.Listener() {});
        assertTrue(Awaited.next(connected, told) instanceof String);
        publisher.publish(message);
        assertTrue(Awaited.next(heard, told) instanceof UDictionary);
        // The last one is closed with its node only, while messages come.
        for (int j = 0; j < 100; j++) publisher.publish(message);
        if (i < 2) subscription.close();
        node.close();
        node.close();
        heard.clear();
        publisher.publish(message);
        own.publish(message);
        assertEquals(0, own.subscribers());
        assertThrows(
            RosException.class,
            () -> node.advertise("z", string, Qos.DEFAULT, new Publisher.Listener() {}));
        assertTrue(heard.isEmpty());
      }
      assertTrue(told.isEmpty(), told::toString);
    }
  }
}

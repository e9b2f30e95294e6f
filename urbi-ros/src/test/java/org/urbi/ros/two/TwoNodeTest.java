package org.urbi.ros.two;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.ros.Awaited;
import org.urbi.ros.Lent;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.graph.ServiceServer;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.rcl.Ways;
import org.urbi.ros.rtps.Neighbourhood;
import org.urbi.ros.rtps.Peer;
import urbi.UDictionary;

/** A node among those of a real ROS 2, of two distributions. */
class TwoNodeTest {
  private static final String HASH =
      "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18";

  private static TwoSettings settings(int domain, String prefix, String name) {
    return TwoSettings.of(
        Map.of("ROS_DOMAIN_ID", "" + domain, "AMENT_PREFIX_PATH", prefix, "ROS_NAMESPACE", "/urbi"),
        name,
        Map.of());
  }

  private final BlockingQueue<String> told = new LinkedBlockingQueue<>();

  private TwoNode start(TwoSettings settings) {
    return TwoNode.start(settings, told::add);
  }

  private static ServiceServer.Handler increment(ServiceType type) {
    return request ->
        CompletableFuture.completedFuture(
            Templates.of(type.response())
                .with("int32_value", request.get("int32_value").doubleValue() + 1)
                .with("string_value", request.get("string_value").stringValue() + "!"));
  }

  private static final class Heard implements Subscription.Listener {
    final BlockingQueue<UDictionary> messages = new LinkedBlockingQueue<>();
    final BlockingQueue<MessageType> types = new LinkedBlockingQueue<>();

    @Override
    public void received(UDictionary message) {
      messages.add(message);
    }

    @Override
    public void typed(MessageType type) {
      types.add(type);
    }
  }

  @ParameterizedTest
  @CsvSource({"kilted, embedded", "jazzy, embedded", "kilted, rcl"})
  void isANodeAmongOthers(String environment, String way) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = new Peer(environment, domain.domain());
        Node node =
            Ways.start(
                way, settings(domain.domain(), Peer.prefix(environment), "jnode"), told::add)) {
      MessageType string = node.definitions().message("std_msgs/String");
      Publisher publisher =
          node.advertise("chatter", string, Qos.LATCHED, new Publisher.Listener() {});
      publisher.publish(Templates.of(string).with("data", "0:hello"));
      peer.say("graph jnode /urbi/chatter");
      peer.expect("/urbi jnode std_msgs/msg/String " + HASH);
      Heard heard = new Heard();
      Subscription subscription = node.subscribe("/back", null, Qos.DEFAULT, heard);
      peer.say("publish back 3 4 20");
      peer.expect("matched");
      for (int i = 0; i < 3; i++)
        assertEquals(i + ":xxxx", Awaited.next(heard.messages).get("data").stringValue());
      peer.expect("published");
      assertEquals("std_msgs/msg/String", Awaited.next(heard.types).name().toString());
      assertEquals(1, subscription.publishers());
      ServiceType type = node.definitions().service("test_msgs/BasicTypes");
      ServiceServer server = node.serve("increment", type, increment(type));
      peer.say("call /urbi/increment 41");
      peer.expect("42 hello!");
      server.close();
      peer.say("serve /increment");
      peer.expect("serving");
      ServiceClient client = Awaited.value(node.client("/increment", type, true));
      UDictionary request =
          Templates.of(type.request()).with("int32_value", 7).with("string_value", "seven");
      for (int i = 0; i < 10; i++) {
        UDictionary answer = Awaited.value(client.request(request));
        assertEquals(8, answer.get("int32_value").doubleValue());
        assertEquals("seven!", answer.get("string_value").stringValue());
      }
      GraphSnapshot graph = Awaited.value(node.graph());
      assertTrue(graph.nodes().get("/peer").publishes().contains("/back"), graph::toString);
      assertEquals(
          List.of("/parameter_events", "/rosout", "/urbi/chatter"),
          graph.nodes().get("/urbi/jnode").publishes());
      assertEquals("std_msgs/msg/String", graph.topics().get("/back").type());
      assertEquals(List.of("/urbi/jnode"), graph.topics().get("/back").subscribers());
      assertEquals(
          new GraphSnapshot.ServiceInfo("test_msgs/srv/BasicTypes", List.of("/peer")),
          graph.services().get("/increment"));
      peer.kill();
    }
  }

  @ParameterizedTest
  @CsvSource({"embedded, embedded", "embedded, rcl", "rcl, embedded", "rcl, rcl"})
  void twoNodesFindEachOther(String first, String second) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node one = Ways.start(first, settings(domain.domain(), "", "one"), told::add);
        Node two = Ways.start(second, settings(domain.domain(), "", "/far/two"), told::add)) {
      MessageType string = one.definitions().message("std_msgs/String");
      BlockingQueue<String> connected = new LinkedBlockingQueue<>();
      Publisher publisher =
          one.advertise(
              "x",
              string,
              Qos.DEFAULT,
              new Publisher.Listener() {
                @Override
                public void connected(String node) {
                  connected.add(node);
                }

                @Override
                public void disconnected(String node) {
                  connected.add("not " + node);
                }
              });
      Heard heard = new Heard();
      Subscription subscription = two.subscribe("/urbi/x", string, Qos.DEFAULT, heard);
      Awaited.next(connected);
      // A listener that fails does not end what it listens to.
      two.subscribe(
          "/urbi/x",
          string,
          Qos.DEFAULT,
          message -> {
            throw new IllegalStateException("on purpose");
          });
      Awaited.next(connected);
      Lent lent = new Lent();
      two.subscribe("/urbi/x", string, Qos.DEFAULT, lent);
      Awaited.next(connected);
      publisher.publish(Templates.of(string).with("data", "hello"));
      assertEquals("hello", Awaited.next(heard.messages).get("data").stringValue());
      assertTrue(lent.next().startsWith("000100000600000068656c6c6f00"));
      publisher.publish(Templates.of(string).with("data", "hi"));
      assertEquals("hi", Awaited.next(heard.messages).get("data").stringValue());
      assertTrue(lent.next().startsWith("0001000003000000686900"));
      Awaited.until("/far/two", () -> Awaited.value(one.graph()).nodes().containsKey("/far/two"));
      subscription.close();
      assertTrue(Awaited.next(connected).startsWith("not "));
      assertEquals(2, publisher.subscribers());
    }
  }

  @Test
  void whatIsWrongIsTold() throws Exception {
    assertThrows(
        RosException.class, () -> TwoSettings.of(Map.of("ROS_DOMAIN_ID", "many"), "x", Map.of()));
    assertThrows(
        RosException.class, () -> TwoSettings.of(Map.of("ROS_IP", "nowhere"), "x", Map.of()));
    assertThrows(
        RosException.class,
        () -> TwoSettings.of(Map.of("ROS_AUTOMATIC_DISCOVERY_RANGE", "HERE"), "x", Map.of()));
    assertThrows(RosException.class, () -> start(settings(1000, "", "x")));
    try (Neighbourhood domain = new Neighbourhood();
        TwoNode node = start(settings(domain.domain(), "", "one"))) {
      CompletionException none =
          assertThrows(
              CompletionException.class, () -> Awaited.value(node.client("none", null, false)));
      assertEquals(
          "there is no service /urbi/none: Ros.services has all", none.getCause().getMessage());
    }
  }

  @Test
  void theRangeOfDiscovery() throws Exception {
    assertTrue(settings(1, "", "x").address().isLoopbackAddress());
    Map<String, String> off = Map.of("ROS_AUTOMATIC_DISCOVERY_RANGE", "off");
    assertTrue(TwoSettings.of(off, "x", Map.of()).isAlone());
    Map<String, String> subnet =
        Map.of("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET", "ROS_IP", "127.0.0.2");
    assertEquals("127.0.0.2", TwoSettings.of(subnet, "x", Map.of()).address().getHostAddress());
    try (Neighbourhood domain = new Neighbourhood();
        TwoNode one = start(settings(domain.domain(), "", "one"));
        TwoNode alone =
            start(
                TwoSettings.of(
                    Map.of(
                        "ROS_DOMAIN_ID",
                        "" + domain.domain(),
                        "ROS_AUTOMATIC_DISCOVERY_RANGE",
                        "OFF"),
                    "alone",
                    Map.of()))) {
      assertEquals(List.of("/urbi/one"), List.copyOf(Awaited.value(one.graph()).nodes().keySet()));
      assertEquals(List.of("/alone"), List.copyOf(Awaited.value(alone.graph()).nodes().keySet()));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"embedded", "rcl"})
  void otherTypesAreTold(String way) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node one = Ways.start(way, settings(domain.domain(), "", "one"), told::add);
        TwoNode two = TwoNode.start(settings(domain.domain(), "", "two"), text -> {})) {
      one.advertise(
          "x",
          one.definitions().message("std_msgs/String"),
          Qos.DEFAULT,
          new Publisher.Listener() {});
      two.subscribe("x", two.definitions().message("std_msgs/Int32"), Qos.DEFAULT, new Heard());
      assertEquals(
          "/urbi/x: /urbi/two subscribes to std_msgs/msg/Int32, this node has std_msgs/msg/String",
          Awaited.next(told));
    }
  }

  /** Who takes any type keeps that of the first publisher: another one is told, in both orders. */
  @ParameterizedTest
  @ValueSource(strings = {"embedded", "rcl"})
  void aTypeThatChangesIsToldAndSurvived(String way) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node one = Ways.start(way, settings(domain.domain(), "", "one"), told::add);
        TwoNode two = TwoNode.start(settings(domain.domain(), "", "two"), text -> {})) {
      MessageType string = two.definitions().message("std_msgs/String");
      MessageType number = two.definitions().message("std_msgs/Int32");
      Heard heard = new Heard();
      one.subscribe("x", null, Qos.DEFAULT, heard);
      assertHeard("before", heard, two, string);
      assertEquals(string.name(), Awaited.next(heard.types).name());
      two.advertise("x", number, Qos.DEFAULT, new Publisher.Listener() {});
      assertEquals(
          "/urbi/x: /urbi/two publishes std_msgs/msg/Int32, this node has std_msgs/msg/String",
          Awaited.next(told));
      assertHeard("after", heard, two, string);
      two.advertise("y", number, Qos.DEFAULT, new Publisher.Listener() {});
      Awaited.until("/urbi/y", () -> Awaited.value(one.graph()).topics().containsKey("/urbi/y"));
      one.subscribe("y", string, Qos.DEFAULT, new Heard());
      assertEquals(
          "/urbi/y: /urbi/two publishes std_msgs/msg/Int32, this node has std_msgs/msg/String",
          Awaited.next(told));
    }
  }

  /** A publisher that comes, says something and goes is heard. */
  private static void assertHeard(String text, Heard heard, Node node, MessageType string)
      throws Exception {
    BlockingQueue<String> connected = new LinkedBlockingQueue<>();
    try (Publisher publisher =
        node.advertise(
            "x",
            string,
            Qos.DEFAULT,
            new Publisher.Listener() {
              @Override
              public void connected(String other) {
                connected.add(other);
              }
            })) {
      Awaited.next(connected);
      publisher.publish(Templates.of(string).with("data", text));
      assertEquals(text, Awaited.next(heard.messages).get("data").stringValue());
    }
  }

  @Test
  void otherTypesOfServicesAreTold() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        TwoNode one = start(settings(domain.domain(), "", "one"));
        TwoNode two = TwoNode.start(settings(domain.domain(), "", "two"), text -> {})) {
      ServiceType trigger = one.definitions().service("std_srvs/Trigger");
      one.serve("s", trigger, request -> new CompletableFuture<>());
      CompletionException refused =
          assertThrows(
              CompletionException.class,
              () ->
                  Awaited.value(
                      two.client("s", two.definitions().service("std_srvs/Empty"), true)));
      assertTrue(refused.getCause().getMessage().contains("of another type"));
      assertEquals(
          "/urbi/s: /urbi/two calls std_srvs/srv/Empty, this node has std_srvs/srv/Trigger",
          Awaited.next(told));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"embedded", "rcl"})
  void deliveryThatIsNotOfferedIsTold(String way) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node one = Ways.start(way, settings(domain.domain(), "", "one"), told::add);
        TwoNode two = start(settings(domain.domain(), "", "two"))) {
      MessageType string = one.definitions().message("std_msgs/String");
      BlockingQueue<String> failed = new LinkedBlockingQueue<>();
      one.advertise(
          "x",
          string,
          Qos.SENSOR_DATA,
          new Publisher.Listener() {
            @Override
            public void failed(String reason) {
              failed.add(reason);
            }
          });
      two.subscribe("x", string, Qos.DEFAULT, new Heard());
      assertEquals("/urbi/two asks for reliability that is not offered here", Awaited.next(failed));
    }
  }

  @ParameterizedTest
  @CsvSource({"kilted, embedded", "jazzy, embedded", "kilted, rcl"})
  void aServerThatDiesInTheMiddle(String environment, String way) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = Peer.ofShortLease(environment, domain.domain());
        Node node =
            Ways.start(
                way, settings(domain.domain(), Peer.prefix(environment), "node"), told::add)) {
      peer.say("silent /hangs");
      peer.expect("serving");
      // A busy machine may take longer to tell of it than is waited for what need not be there.
      Awaited.until("/hangs", () -> Awaited.value(node.graph()).services().containsKey("/hangs"));
      ServiceClient client = Awaited.value(node.client("/hangs", null, true));
      CompletableFuture<UDictionary> answer = client.request(Templates.of(client.type().request()));
      peer.expect("asked");
      peer.kill();
      CompletionException gone = assertThrows(CompletionException.class, answer::join);
      assertEquals("the service /hangs has gone", gone.getCause().getMessage());
    }
  }

  @Test
  void answersThatAreNone() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        TwoNode node = start(settings(domain.domain(), "", "node"));
        HostileServer server = new HostileServer(domain)) {
      Awaited.until("/bad", () -> Awaited.value(node.graph()).services().containsKey("/bad"));
      ServiceClient client = Awaited.value(node.client("/bad", null, true));
      CompletableFuture<UDictionary> answer = client.request(new UDictionary());
      CompletionException bad = assertThrows(CompletionException.class, answer::join);
      assertTrue(bad.getCause().getMessage().startsWith("/bad answers what is none: "));
      server.goesOn = false;
      answer = client.request(new UDictionary());
      server.close();
      CompletionException gone = assertThrows(CompletionException.class, answer::join);
      assertEquals("the service /bad has gone", gone.getCause().getMessage());
    }
  }
}

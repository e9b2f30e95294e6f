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
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.graph.ServiceServer;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.Templates;
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
  @ValueSource(strings = {"kilted", "jazzy"})
  void isANodeAmongOthers(String environment) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = new Peer(environment, domain.domain());
        TwoNode node =
            TwoNode.start(settings(domain.domain(), Peer.prefix(environment), "jnode"))) {
      MessageType string = node.settings().definitions().message("std_msgs/String");
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
        assertEquals(i + ":xxxx", heard.messages.take().get("data").stringValue());
      peer.expect("published");
      assertEquals("std_msgs/msg/String", heard.types.take().name().toString());
      assertEquals(1, subscription.publishers());
      ServiceType type = node.settings().definitions().service("test_msgs/BasicTypes");
      ServiceServer server = node.serve("increment", type, increment(type));
      peer.say("call /urbi/increment 41");
      peer.expect("42 hello!");
      server.close();
      peer.say("serve /increment");
      peer.expect("serving");
      ServiceClient client = node.client("/increment", type, true).join();
      UDictionary request =
          Templates.of(type.request()).with("int32_value", 7).with("string_value", "seven");
      for (int i = 0; i < 10; i++) {
        UDictionary answer = client.request(request).join();
        assertEquals(8, answer.get("int32_value").doubleValue());
        assertEquals("seven!", answer.get("string_value").stringValue());
      }
      GraphSnapshot graph = node.graph().join();
      assertTrue(graph.nodes().get("/peer").publishes().contains("/back"), graph::toString);
      assertEquals(List.of("/urbi/chatter"), graph.nodes().get("/urbi/jnode").publishes());
      assertEquals("std_msgs/msg/String", graph.topics().get("/back").type());
      assertEquals(List.of("/urbi/jnode"), graph.topics().get("/back").subscribers());
      assertEquals(
          new GraphSnapshot.ServiceInfo("test_msgs/srv/BasicTypes", List.of("/peer")),
          graph.services().get("/increment"));
      peer.kill();
    }
  }

  @Test
  void twoNodesFindEachOther() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        TwoNode one = TwoNode.start(settings(domain.domain(), "", "one"));
        TwoNode two = TwoNode.start(settings(domain.domain(), "", "/far/two"))) {
      MessageType string = one.settings().definitions().message("std_msgs/String");
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
      connected.take();
      // A listener that fails does not end what it listens to.
      two.subscribe(
          "/urbi/x",
          string,
          Qos.DEFAULT,
          message -> {
            throw new IllegalStateException("on purpose");
          });
      connected.take();
      publisher.publish(Templates.of(string).with("data", "hello"));
      assertEquals("hello", heard.messages.take().get("data").stringValue());
      publisher.publish(Templates.of(string).with("data", "hi"));
      assertEquals("hi", heard.messages.take().get("data").stringValue());
      while (!one.graph().join().nodes().containsKey("/far/two")) Thread.sleep(1);
      subscription.close();
      assertTrue(connected.take().startsWith("not "));
      assertEquals(1, publisher.subscribers());
    }
  }

  @Test
  void whatIsWrongIsTold() throws Exception {
    assertThrows(
        RosException.class, () -> TwoSettings.of(Map.of("ROS_DOMAIN_ID", "many"), "x", Map.of()));
    assertThrows(
        RosException.class, () -> TwoSettings.of(Map.of("ROS_IP", "nowhere"), "x", Map.of()));
    assertThrows(RosException.class, () -> TwoNode.start(settings(1000, "", "x")));
    try (Neighbourhood domain = new Neighbourhood();
        TwoNode node = TwoNode.start(settings(domain.domain(), "", "one"))) {
      CompletionException none =
          assertThrows(CompletionException.class, () -> node.client("none", null, false).join());
      assertEquals(
          "there is no service /urbi/none: no node offers it", none.getCause().getMessage());
    }
  }
}

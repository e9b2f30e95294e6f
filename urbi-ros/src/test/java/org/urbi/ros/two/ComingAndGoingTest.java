package org.urbi.ros.two;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.urbi.ros.Awaited;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.rtps.Neighbourhood;
import org.urbi.ros.rtps.Peer;
import urbi.UDictionary;

/** Peers come, die and come back: each is heard, and nothing of them is left. */
class ComingAndGoingTest {
  private static TwoNode start(Neighbourhood domain, String name) {
    return TwoNode.start(
        TwoSettings.of(Map.of("ROS_DOMAIN_ID", "" + domain.domain()), name, Map.of()), text -> {});
  }

  private static void awaitEndpoints(TwoNode node, int count) throws Exception {
    Awaited.until("the endpoints", () -> node.endpoints().size() == count);
  }

  /** Which nodes there are is told after the endpoints have gone. */
  private static void awaitAlone(TwoNode stays) throws Exception {
    Awaited.until(
        "/stays alone",
        () -> Set.of("/stays").equals(Awaited.value(stays.graph()).nodes().keySet()));
  }

  @Test
  void nodesThatSayGoodBye() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        TwoNode stays = start(domain, "stays")) {
      MessageType string = stays.definitions().message("std_msgs/String");
      BlockingQueue<UDictionary> heard = new LinkedBlockingQueue<>();
      stays.subscribe("/come", string, Qos.LATCHED, heard::add);
      Publisher publisher =
          stays.advertise("/stay", string, Qos.DEFAULT, new Publisher.Listener() {});
      int own = stays.endpoints().size();
      for (int i = 0; i < 30; i++) {
        try (TwoNode comes = start(domain, "comes" + i % 3)) {
          BlockingQueue<UDictionary> back = new LinkedBlockingQueue<>();
          comes.subscribe("/stay", string, Qos.DEFAULT, back::add);
          Publisher there =
              comes.advertise("/come", string, Qos.LATCHED, new Publisher.Listener() {});
          there.publish(Templates.of(string).with("data", "visit " + i));
          assertEquals("visit " + i, Awaited.next(heard).get("data").stringValue());
          Awaited.until("a subscriber", () -> publisher.subscribers() > 0);
          publisher.publish(Templates.of(string).with("data", "welcome"));
          Awaited.next(back);
        }
        awaitEndpoints(stays, own);
        assertEquals(0, publisher.subscribers());
      }
      awaitAlone(stays);
      assertTrue(heard.isEmpty());
    }
  }

  @Test
  void peersThatDie() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        TwoNode stays = start(domain, "stays")) {
      MessageType string = stays.definitions().message("std_msgs/String");
      BlockingQueue<UDictionary> heard = new LinkedBlockingQueue<>();
      stays.subscribe("/come", string, Qos.DEFAULT, heard::add);
      int own = stays.endpoints().size();
      for (String environment : List.of("kilted", "jazzy")) {
        try (Peer peer = Peer.ofShortLease(environment, domain.domain())) {
          peer.say("publish come 100000 1000 1000");
          peer.expect("matched");
          Awaited.next(heard);
          peer.kill();
        }
        awaitEndpoints(stays, own);
      }
      // Its node is forgotten with the participant, after the endpoints.
      awaitAlone(stays);
    }
  }
}

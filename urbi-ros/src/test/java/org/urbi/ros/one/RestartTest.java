package org.urbi.ros.one;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.ros.Awaited;
import org.urbi.ros.FreePorts;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.graph.Subscription;
import urbi.UDictionary;
import urbi.UValue;

/** Masters and peers that come late, die, and come back. */
class RestartTest {
  @TempDir static Path logs;

  @BeforeAll
  static void look() {
    assumeTrue(RosProcess.isInstalled(), "there is no ROS 1 on this machine");
  }

  private static RosProcess peer(int port) throws Exception {
    RosProcess started =
        RosProcess.start(
            port, logs, "/usr/bin/python3", Path.of("src/test/oracles/peer.py").toString());
    started.await("ready");
    return started;
  }

  @Test
  void aMasterThatIsAwayComesAndGoesAndComesBack() throws Exception {
    int port = FreePorts.next();
    BlockingQueue<Boolean> presence = new LinkedBlockingQueue<>();
    OneNode node =
        OneNode.start(
            OneSettings.of(RosProcess.environment(port), "tested", Map.of()), presence::add);
    try {
      assertEquals(false, Awaited.next(presence));
      assertEquals(false, node.reachable().get());
      assertThrows(CompletionException.class, () -> Awaited.value(node.graph()));
      Heard heard = new Heard();
      Subscription chatter = node.subscribe("chatter", null, Qos.DEFAULT, heard);
      node.advertise(
          "ours",
          node.definitions().message("std_msgs/String"),
          Qos.DEFAULT,
          new Publisher.Listener() {});
      node.serve(
          "served",
          node.definitions().service("std_srvs/Empty"),
          request -> CompletableFuture.completedFuture(new UDictionary()));
      for (int i = 0; i < 2; i++) {
        try (RosProcess master = RosProcess.master(port, logs);
            RosProcess peer = peer(port)) {
          assertEquals(true, Awaited.next(presence));
          heard.messages.clear();
          assertTrue(heard.text().startsWith("hello"));
          var graph = node.graph().get();
          while (!graph.services().containsKey("/served")) {
            graph = node.graph().get();
          }
          assertEquals("std_msgs/String", graph.topics().get("/ours").type());
        }
        assertEquals(false, Awaited.next(presence));
        Awaited.until("no publisher", () -> chatter.publishers() == 0);
      }
      assertTrue(heard.failures.isEmpty(), heard.failures::toString);
    } finally {
      node.close();
    }
  }

  @Test
  void whatAMasterKeptIsGoneWithIt() throws Exception {
    int port = FreePorts.next();
    BlockingQueue<Boolean> presence = new LinkedBlockingQueue<>();
    OneNode node =
        OneNode.start(
            OneSettings.of(RosProcess.environment(port), "tested", Map.of()), presence::add);
    try {
      assertEquals(false, Awaited.next(presence));
      try (RosProcess master = RosProcess.master(port, logs)) {
        assertEquals(true, Awaited.next(presence));
        node.parameters().set("/use_sim_time", new UValue(true)).get();
        assertEquals(0, node.now(), "nobody has told the time");
      }
      assertEquals(false, Awaited.next(presence));
      try (RosProcess another = RosProcess.master(port, logs)) {
        assertEquals(true, Awaited.next(presence));
        Awaited.until("the time of people", () -> node.now() > 1e18);
      }
    } finally {
      node.close();
    }
  }

  @Test
  void aPeerThatDiesIsNoticedAndOneThatComesBackIsHeard() throws Exception {
    int port = FreePorts.next();
    try (RosProcess master = RosProcess.master(port, logs)) {
      OneNode node = OneNodeTest.node(port, "tested");
      try {
        BlockingQueue<String> told = new LinkedBlockingQueue<>();
        Heard heard = new Heard();
        ServiceClient client;
        node.advertise(
            "/echo_in",
            node.definitions().message("std_msgs/String"),
            Qos.DEFAULT,
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
        node.subscribe("/chatter", null, Qos.DEFAULT, heard);
        try (RosProcess peer = peer(port)) {
          assertEquals("+/peer", Awaited.next(told));
          heard.text();
          client = node.client("/set_bool", null, true).get();
          client.request(new UDictionary().with("data", true)).get();
        }
        assertEquals("-/peer", Awaited.next(told));
        CompletionException gone =
            assertThrows(
                CompletionException.class,
                () -> Awaited.value(client.request(new UDictionary().with("data", true))));
        assertTrue(gone.getCause() instanceof RosException, gone.getMessage());
        heard.messages.clear();
        try (RosProcess peer = peer(port)) {
          assertEquals("+/peer", Awaited.next(told));
          heard.text();
          client.request(new UDictionary().with("data", true)).get();
        }
      } finally {
        node.close();
      }
    }
  }
}

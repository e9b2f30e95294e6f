package org.urbi.ros.one;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.ros.Awaited;
import org.urbi.ros.FreePorts;
import org.urbi.ros.graph.ActionClient;
import org.urbi.ros.graph.ActionServer;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.GraphSnapshot.ActionInfo;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.ActionType;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.TypeHash;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** Actions of ROS 1, with a node that has Debian's actionlib. */
class OneActionsTest {
  private static final Qos QOS = Qos.DEFAULT;

  @TempDir static Path logs;
  private int port;
  private RosProcess master;
  private RosProcess peer;
  private OneNode node;

  private final BlockingQueue<ActionServer.Goal> held = new LinkedBlockingQueue<>();
  private final BlockingQueue<UDictionary> steps = new LinkedBlockingQueue<>();
  private final BlockingQueue<GoalStatus> statuses = new LinkedBlockingQueue<>();

  private final ActionClient.Listener listener =
      new ActionClient.Listener() {
        @Override
        public void feedback(UDictionary feedback) {
          steps.add(feedback);
        }

        @Override
        public void status(GoalStatus status) {
          statuses.add(status);
        }
      };

  /** As that of the peer. */
  private final ActionServer.Handler handler =
      new ActionServer.Handler() {
        @Override
        public CompletionStage<Boolean> goal(ActionServer.Goal goal) {
          double order = goal.request().get("goal").doubleValue();
          CompletableFuture<Boolean> accepted = CompletableFuture.completedFuture(order >= 0);
          accepted.thenAcceptAsync(good -> {
            if (!good) {
              return;
            }
            goal.feedback(new UDictionary().with("feedback", 1));
            if (order >= 100) {
              held.add(goal);
            } else {
              goal.end(order > 0 ? GoalStatus.SUCCEEDED : GoalStatus.ABORTED, result(order + 5));
            }
          });
          return accepted;
        }

        @Override
        public void cancel(ActionServer.Goal goal) {
          goal.end(GoalStatus.CANCELED, result(7));
        }
      };

  private static UDictionary goal(double order) {
    return new UDictionary().with("goal", order);
  }

  private static UDictionary result(double number) {
    return new UDictionary().with("result", number);
  }

  @BeforeEach
  void start() throws Exception {
    assumeTrue(RosProcess.isInstalled(), "there is no ROS 1 on this machine");
    assumeTrue(
        Files.isDirectory(Path.of("/usr/lib/python3/dist-packages/actionlib")),
        "there is no actionlib on this machine");
    port = FreePorts.next();
    master = RosProcess.master(port, logs);
    Map<String, String> environment = new HashMap<>(RosProcess.environment(port));
    environment.put(
        "ROS_PACKAGE_PATH", Path.of("src/test/oracles/share").toAbsolutePath().toString());
    node = OneNode.start(OneSettings.of(environment, "/tested", Map.of()), present -> {});
    Awaited.until("there is a master", () -> Awaited.value(node.reachable()));
  }

  @AfterEach
  void end() throws IOException {
    if (node != null) {
      node.close();
    }
    for (RosProcess each : new RosProcess[] {peer, master}) {
      if (each != null) {
        each.close();
      }
    }
  }

  private void startPeer(String... arguments) throws Exception {
    String script = Path.of("src/test/oracles/goals.py").toString();
    String[] command =
        arguments.length == 0
            ? new String[] {"/usr/bin/python3", script}
            : new String[] {"/usr/bin/python3", script, arguments[0]};
    peer = RosProcess.start(port, logs, command);
    peer.await("ready");
  }

  private void awaitAction(String name) throws Exception {
    Awaited.until(name, () -> Awaited.value(node.graph()).actions().containsKey(name));
  }

  private ActionType type() {
    return node.definitions().action("actionlib/Test");
  }

  private static <T> String failure(CompletableFuture<T> promise) {
    return assertThrows(CompletionException.class, () -> Awaited.value(promise))
        .getCause()
        .getMessage();
  }

  @Test
  void goalsThatOthersPursue() throws Exception {
    startPeer();
    awaitAction("/count");
    assertEquals(
        new ActionInfo("actionlib/Test", List.of("/goals")),
        Awaited.value(node.graph()).actions().get("/count"));
    ActionClient client = Awaited.value(node.actions().client("/count", null));
    assertEquals("actionlib/Test", client.type().name().in(node.version()));
    assertEquals(
        new ActionClient.Outcome(GoalStatus.SUCCEEDED, result(3)),
        Awaited.value(client.send(goal(3), listener).outcome()));
    assertEquals(
        new ActionClient.Outcome(GoalStatus.ABORTED, result(5)),
        Awaited.value(client.send(goal(0), listener).outcome()));
    ActionClient.Goal refused = client.send(goal(-1), listener);
    assertEquals("/count refuses the goal: never", failure(refused.accepted()));
    assertEquals("/count refuses the goal: never", failure(refused.outcome()));
    steps.clear();
    ActionClient.Goal endless = client.send(goal(1000), listener);
    Awaited.value(endless.accepted());
    // That of a goal that ends at once comes on its own way, possibly too late.
    assertEquals(new UDictionary().with("feedback", 1), Awaited.next(steps, statuses));
    assertTrue(Awaited.value(endless.cancel()));
    assertEquals(
        new ActionClient.Outcome(GoalStatus.CANCELED, result(7)), Awaited.value(endless.outcome()));
    assertTrue(Awaited.value(endless.cancel()), "it has ended");
    assertThrows(RuntimeException.class, () -> client.send(result(1), listener));
    ActionClient.Goal left = client.send(goal(1000), listener);
    Awaited.value(left.accepted());
    peer.close();
    assertEquals("the action /count has gone", failure(left.outcome()));
    assertEquals(
        "there is no action /none: Ros.actions has all",
        failure(node.actions().client("/none", null)));
  }

  @Test
  void goalsThatOthersSend() throws Exception {
    ActionServer server = node.actions().serve("/ours", type(), handler);
    startPeer("goals");
    peer.says("goal 3 state 3 result 8");
    peer.says("goal -1 state 5 result 0");
    peer.says("goal 0 state 4 result 5");
    peer.says("told 1");
    peer.says("goal 1000 state 2 result 7");
    server.close();
  }

  @Test
  void clientsThatDoNotKeepToTheRules() throws Exception {
    ActionServer server = node.actions().serve("/ours", type(), handler);
    assertThrows(RosException.class, () -> node.actions().serve("/ours", type(), handler));
    awaitAction("/ours");
    ActionClient client = Awaited.value(node.actions().client("/ours", type()));
    MessageType goalMessage = ((ActionType.One) type()).goalMessage();
    BlockingQueue<String> heard = new LinkedBlockingQueue<>();
    Publisher.Listener listens =
        new Publisher.Listener() {
          @Override
          public void connected(String name) {
            heard.add(name);
          }
        };
    MessageType goalId = node.definitions().message("actionlib_msgs/GoalID");
    try (Publisher raw = node.advertise("/ours/goal", goalMessage, QOS, listens);
        Publisher cancel = node.advertise("/ours/cancel", goalId, QOS, listens)) {
      Awaited.next(heard);
      Awaited.next(heard);
      UDictionary same = Templates.of(goalMessage);
      same.get("goal_id").udictionaryValue().put("id", new UValue("same"));
      same.with("goal", goal(200));
      raw.publish(same);
      raw.publish(same);
      Awaited.next(held, statuses);
      ActionClient.Goal own = client.send(goal(300), listener);
      assertEquals(
          300, Awaited.next(held, statuses).request().get("goal").doubleValue(), "the same once");
      Awaited.value(own.accepted());
      // One that nobody knows, then all.
      cancel.publish(Templates.of(goalId).with("id", "unknown"));
      cancel.publish(Templates.of(goalId));
      assertEquals(GoalStatus.CANCELED, Awaited.value(own.outcome()).status());
      ActionClient.Goal last = client.send(goal(400), listener);
      Awaited.next(held, statuses);
      server.close();
      String end =
          Awaited.value(
              last.outcome()
                  .handle((ended, failure) ->
                      failure == null ? ended.status().toString() : failure.getMessage()));
      assertTrue(end.equals("aborted") || end.contains("has gone"), end);
    }
  }

  /** A server that keeps its result to itself, as one whose connection broke at the wrong time. */
  @Test
  void anEndWithoutAResult() throws Exception {
    ActionType.One type = (ActionType.One) type();
    MessageType goalId = node.definitions().message("actionlib_msgs/GoalID");
    MessageType array = node.definitions().message("actionlib_msgs/GoalStatusArray");
    Publisher.Listener nobody = new Publisher.Listener() {};
    BlockingQueue<UDictionary> goals = new LinkedBlockingQueue<>();
    try (Publisher result = node.advertise("/odd/result", type.resultMessage(), QOS, nobody);
        Publisher feedback = node.advertise("/odd/feedback", type.feedbackMessage(), QOS, nobody);
        Publisher status = node.advertise("/odd/status", array, QOS, nobody);
        Subscription goal = node.subscribe("/odd/goal", type.goalMessage(), QOS, goals::add);
        Subscription cancel = node.subscribe("/odd/cancel", goalId, QOS, message -> {})) {
      awaitAction("/odd");
      CompletableFuture<ActionClient> found = node.actions().client("/odd", type);
      Awaited.until(
          "a client",
          () -> {
            status.publish(Templates.of(array));
            return found.isDone();
          });
      ActionClient.Goal sent = Awaited.value(found).send(goal(1), listener);
      UDictionary id = Awaited.next(goals).get("goal_id").udictionaryValue();
      UDictionary ended = new UDictionary().with("goal_id", id).with("status", 3).with("text", "");
      UDictionary told = Templates.of(array);
      told.put("status_list", new UValue(new UList(List.of(new UValue(ended)))));
      status.publish(told);
      assertEquals("/odd has ended the goal, but tells no result", failure(sent.outcome()));
    }
  }

  /** The sums are those that the package actionlib has. */
  @Test
  void whatTravelsIsWhatActionlibMakesOfAnAction() {
    ActionType.One one = (ActionType.One) type();
    assertEquals("actionlib/TestActionGoal", one.goalMessage().name().in(node.version()));
    assertEquals("348369c5b403676156094e8c159720bf", TypeHash.md5(one.goalMessage()));
    assertEquals("3d669e3a63aa986c667ea7b0f46ce85e", TypeHash.md5(one.resultMessage()));
    assertEquals("6d3d0bf7fb3dda24779c010a9f3eb7cb", TypeHash.md5(one.feedbackMessage()));
  }
}

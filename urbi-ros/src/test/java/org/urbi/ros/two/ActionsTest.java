package org.urbi.ros.two;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.ros.Awaited;
import org.urbi.ros.graph.ActionClient;
import org.urbi.ros.graph.ActionServer;
import org.urbi.ros.graph.GoalStatus;
import org.urbi.ros.graph.GraphSnapshot.TopicInfo;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.graph.ServiceServer;
import org.urbi.ros.message.ActionType;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.ValueException;
import org.urbi.ros.rcl.Ways;
import org.urbi.ros.rtps.Neighbourhood;
import org.urbi.ros.rtps.Peer;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** Actions of ROS 2, with those of a real one of two distributions. */
class ActionsTest {
  private static final String SCRIPT = "actions.py";

  /** Where test_msgs are. */
  private static final Path TYPES =
      Path.of("src/test/resources/org/urbi/ros").toAbsolutePath().normalize();

  private static Node start(Neighbourhood domain, String name) {
    return start("embedded", domain, name);
  }

  private static Node start(String way, Neighbourhood domain, String name) {
    return Ways.start(
        way,
        TwoSettings.of(
            Map.of("ROS_DOMAIN_ID", "" + domain.domain(), "AMENT_PREFIX_PATH", TYPES.toString()),
            name,
            Map.of()),
        text -> {});
  }

  private static ActionType.Two fibonacci(Node node) {
    return (ActionType.Two) node.definitions().action("test_msgs/Fibonacci");
  }

  private static UDictionary goal(int order) {
    return new UDictionary().with("order", order);
  }

  private static UDictionary sequence(double... numbers) {
    UList list = new UList();
    for (double each : numbers) list.add(new UValue(each));
    return new UDictionary().with("sequence", new UValue(list));
  }

  /** What comes of a goal. */
  private static final class Progress implements ActionClient.Listener {
    final BlockingQueue<UDictionary> feedbacks = new LinkedBlockingQueue<>();
    final BlockingQueue<GoalStatus> statuses = new LinkedBlockingQueue<>();

    @Override
    public void feedback(UDictionary feedback) {
      feedbacks.add(feedback);
    }

    @Override
    public void status(GoalStatus status) {
      statuses.add(status);
    }
  }

  /** Goals as they come; whoever wants to be cancelled is told. */
  private static final class Goals implements ActionServer.Handler {
    final BlockingQueue<ActionServer.Goal> accepted = new LinkedBlockingQueue<>();
    final BlockingQueue<ActionServer.Goal> cancelled = new LinkedBlockingQueue<>();

    @Override
    public CompletionStage<Boolean> goal(ActionServer.Goal goal) {
      boolean isPossible = goal.request().get("order").doubleValue() >= 0;
      if (isPossible) accepted.add(goal);
      return CompletableFuture.completedFuture(isPossible);
    }

    @Override
    public void cancel(ActionServer.Goal goal) {
      cancelled.add(goal);
    }
  }

  private static ActionClient client(Node node, String name) throws Exception {
    // A busy machine may take longer to tell of it than is waited for what need not be there.
    Awaited.until(name, () -> Awaited.value(node.graph()).actions().containsKey(name));
    return Awaited.value(node.actions().client(name, null));
  }

  private static boolean hearsFeedback(String other, Node node) {
    TopicInfo feedback =
        Awaited.value(node.graph()).topics().get("/fibonacci" + TwoActions.FEEDBACK);
    return feedback != null && feedback.subscribers().contains(other);
  }

  private static <T> String failure(CompletableFuture<T> promise) {
    return assertThrows(CompletionException.class, promise::join).getCause().getMessage();
  }

  @ParameterizedTest
  @CsvSource({"kilted, embedded", "jazzy, embedded", "kilted, rcl"})
  void goalsThatOthersPursue(String environment, String way) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = Peer.of(environment, domain.domain(), SCRIPT);
        Node node = start(way, domain, "node")) {
      peer.say("serve /fibonacci count");
      peer.expect("serving");
      ActionClient client = client(node, "/fibonacci");
      assertEquals("test_msgs/action/Fibonacci", client.type().name().toString());
      Progress progress = new Progress();
      ActionClient.Goal five = client.send(goal(5), progress);
      Awaited.value(five.accepted());
      assertEquals(
          new ActionClient.Outcome(GoalStatus.SUCCEEDED, sequence(0, 1, 1, 2, 3, 5)),
          Awaited.value(five.outcome()));
      for (int i = 0; i < 4; i++) Awaited.next(progress.feedbacks);
      assertTrue(progress.feedbacks.isEmpty());
      assertEquals(GoalStatus.ACCEPTED, Awaited.next(progress.statuses));
      assertEquals(
          "/fibonacci refuses the goal", failure(client.send(goal(-1), progress).outcome()));
      assertEquals(
          GoalStatus.ABORTED, Awaited.value(client.send(goal(0), progress).outcome()).status());
      assertThrows(
          ValueException.class, () -> client.send(new UDictionary().with("order", "x"), progress));
      ActionClient.Goal endless = client.send(goal(40), progress);
      Awaited.next(progress.feedbacks);
      assertTrue(Awaited.value(endless.cancel()));
      peer.expect("cancelled");
      assertEquals(GoalStatus.CANCELED, Awaited.value(endless.outcome()).status());
      assertTrue(Awaited.value(endless.cancel()), "what has ended needs not be given up");
      peer.kill();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"kilted", "jazzy"})
  void aServerThatDiesInTheMiddle(String environment) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = Peer.ofShortLease(environment, domain.domain(), SCRIPT);
        Node node = start(domain, "node")) {
      peer.say("serve /fibonacci hang");
      peer.expect("serving");
      ActionClient client = client(node, "/fibonacci");
      ActionClient.Goal goal = client.send(goal(1), new Progress());
      peer.expect("hanging");
      peer.kill();
      assertEquals("the service /fibonacci/_action/get_result has gone", failure(goal.outcome()));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"kilted", "jazzy"})
  void aServerThatDoesNotGiveUp(String environment) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = Peer.of(environment, domain.domain(), SCRIPT);
        Node node = start(domain, "node")) {
      peer.say("serve /fibonacci stubborn");
      peer.expect("serving");
      ActionClient client = client(node, "/fibonacci");
      Progress progress = new Progress();
      ActionClient.Goal goal = client.send(goal(10), progress);
      Awaited.next(progress.feedbacks);
      assertFalse(Awaited.value(goal.cancel()));
      assertEquals(GoalStatus.SUCCEEDED, Awaited.value(goal.outcome()).status());
      peer.kill();
    }
  }

  @ParameterizedTest
  @CsvSource({"kilted, embedded", "jazzy, embedded", "kilted, rcl"})
  void goalsOfOthers(String environment, String way) throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = Peer.of(environment, domain.domain(), SCRIPT);
        Node node = start(way, domain, "node")) {
      Goals goals = new Goals();
      ActionServer server = node.actions().serve("fibonacci", fibonacci(node), goals);
      assertEquals("/fibonacci", server.action());
      peer.say("goal /fibonacci 3 1");
      ActionServer.Goal three = Awaited.next(goals.accepted);
      assertEquals(3, three.request().get("order").doubleValue());
      // A goal may come before it is known that somebody subscribes to its feedback.
      Awaited.until("the client's subscription", () -> hearsFeedback("/peer", node));
      three.feedback(sequence(0, 1));
      assertThrows(ValueException.class, () -> three.feedback(new UDictionary()));
      assertThrows(ValueException.class, () -> three.end(GoalStatus.SUCCEEDED, new UDictionary()));
      three.end(GoalStatus.SUCCEEDED, sequence(0, 1, 1, 2));
      three.end(GoalStatus.ABORTED, sequence());
      peer.expect("4 [0, 1, 1, 2] [0, 1]");
      peer.say("goal /fibonacci -1");
      peer.expect("refused");
      peer.say("cancel /fibonacci 7");
      ActionServer.Goal unwanted = Awaited.next(goals.accepted);
      unwanted.feedback(sequence(0));
      assertEquals(unwanted, Awaited.next(goals.cancelled));
      unwanted.end(GoalStatus.CANCELED, sequence(8));
      peer.expect("0 1 5 [8]");
      peer.say("late /fibonacci 2");
      Awaited.next(goals.accepted).end(GoalStatus.CANCELED, sequence(9));
      peer.expect("6 [9]");
      // A client that has gone leaves its goal behind, as in ROS 2 everywhere.
      peer.say("vanish /fibonacci 4");
      ActionServer.Goal left = Awaited.next(goals.accepted);
      peer.expect("vanishing");
      left.feedback(sequence(1));
      left.end(GoalStatus.SUCCEEDED, sequence(1));
      assertTrue(goals.cancelled.isEmpty());
    }
  }

  @Test
  void betweenNodes() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node one = start(domain, "one");
        Node two = start(domain, "two")) {
      Goals goals = new Goals();
      ActionServer server = one.actions().serve("f", fibonacci(one), goals);
      assertThrows(RosException.class, () -> one.actions().serve("f", fibonacci(one), new Goals()));
      ActionClient client = client(two, "/f");
      ActionClient.Goal first = client.send(goal(1), new Progress());
      ActionClient.Goal second = client.send(goal(2), new Progress());
      Awaited.value(first.accepted());
      Awaited.value(second.accepted());
      ServiceType cancelGoal = two.definitions().service("action_msgs/CancelGoal");
      ServiceClient cancel =
          Awaited.value(two.client("/f" + TwoActions.CANCEL_GOAL, cancelGoal, true));
      UDictionary all = Awaited.value(cancel.request(Templates.of(cancel.type().request())));
      assertEquals(2, all.get("goals_canceling").ulistValue().size());
      assertEquals(Awaited.next(goals.accepted), Awaited.next(goals.cancelled));
      UDictionary unknown = Templates.of(cancel.type().request());
      UDictionary nobody = GoalIds.message(new UUID(1, 1));
      unknown.get("goal_info").udictionaryValue().put("goal_id", nobody);
      assertEquals(
          TwoActions.ERROR_UNKNOWN_GOAL_ID,
          Awaited.value(cancel.request(unknown)).get("return_code").intValue());
      ServiceClient results =
          Awaited.value(two.client("/f" + TwoActions.GET_RESULT, fibonacci(two).getResult(), true));
      assertEquals(
          0,
          Awaited.value(results.request(new UDictionary().with("goal_id", nobody)))
              .get("status")
              .intValue());
      server.close();
      assertEquals(GoalStatus.ABORTED, Awaited.value(first.outcome()).status());
      assertEquals(GoalStatus.ABORTED, Awaited.value(second.outcome()).status());
    }
  }

  /** The node, to whom a goal comes as soon as it offers to take some. */
  private static TwoHost hurried(
      TwoHost node, ActionType.Two type, BlockingQueue<UDictionary> answers) {
    UDictionary request = Templates.of(type.sendGoal().request());
    return (TwoHost)
        Proxy.newProxyInstance(
            TwoHost.class.getClassLoader(),
            new Class<?>[] {TwoHost.class},
            (proxy, method, arguments) -> {
              if (method.getName().equals("serve")
                  && ((String) arguments[0]).endsWith(TwoActions.SEND_GOAL)) {
                ((ServiceServer.Handler) arguments[2]).answer(request).thenAccept(answers::add);
              }
              return method.invoke(node, arguments);
            });
  }

  @Test
  void aGoalThatComesAtOnce() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node node = start(domain, "node")) {
      ActionType.Two type = fibonacci(node);
      BlockingQueue<UDictionary> answers = new LinkedBlockingQueue<>();
      TwoActions actions = new TwoActions(hurried((TwoHost) node, type, answers), new byte[12]);
      Goals goals = new Goals();
      actions.serve("f", type, goals);
      assertEquals(1, Awaited.next(answers).get("accepted").intValue());
      Awaited.next(goals.accepted).end(GoalStatus.SUCCEEDED, sequence(1));
    }
  }

  @Test
  void aClientThatFloods() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node one = start(domain, "one");
        Node two = start(domain, "two")) {
      Goals goals = new Goals();
      one.actions().serve("f", fibonacci(one), goals);
      ActionClient client = client(two, "/f");
      for (int i = 0; i < 1000; i++) {
        Awaited.value(client.send(goal(i), new Progress()).accepted());
      }
      assertEquals("/f refuses the goal", failure(client.send(goal(1), new Progress()).accepted()));
      // Those that have ended make room for others.
      for (int i = 0; i < 500; i++) {
        Awaited.next(goals.accepted).end(GoalStatus.SUCCEEDED, sequence(i));
      }
      ActionClient.Goal last = client.send(goal(7), new Progress());
      Awaited.value(last.accepted());
      goals.accepted.removeIf(each -> each.request().get("order").doubleValue() != 7);
      Awaited.next(goals.accepted).end(GoalStatus.SUCCEEDED, sequence(7));
      assertEquals(sequence(7), Awaited.value(last.outcome()).result());
    }
  }

  @Test
  void aClientThatIsClosedWaitsForNothing() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Node node = start(domain, "one")) {
      node.actions().serve("f", fibonacci(node), new Goals());
      ActionClient client = client(node, "/f");
      ActionClient.Goal goal = client.send(goal(1), new Progress());
      Awaited.value(goal.accepted());
      client.close();
      assertEquals("the client of /f is closed", failure(goal.outcome()));
      assertEquals(
          "there is no action /g: Ros.actions has all", failure(node.actions().client("g", null)));
    }
  }
}

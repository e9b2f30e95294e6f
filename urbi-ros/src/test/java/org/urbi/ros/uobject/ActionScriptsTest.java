package org.urbi.ros.uobject;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.ros.rtps.Neighbourhood;

/** Actions of ROS 2 in urbiscript. */
class ActionScriptsTest extends ScriptsFixture {
  private static final String SCRIPT = "actions.py";

  private static final String OFFERS =
      """
      var Global.server = Ros.offerAction("/ours", "test_msgs/Fibonacci",
        function (var goal)
        {
          if (goal.request["order"] == 0)
            throw Exception.new("nothing to do")|
          var numbers = [0, 1]|
          goal.result["sequence"] = numbers|
          while (numbers.size <= goal.request["order"])
          {
            numbers << numbers[-1] + numbers[-2]|
            goal << ["sequence" => numbers]|
            // Too many are never reached: how far it comes until it is cancelled is known.
            if (goal.request["order"] >= 1000)
              sleep(inf)|
            sleep(50ms)
          }|
          goal.result
        },
        function (var request) { request["order"] >= 0 })|;
      """;

  @ParameterizedTest
  @ValueSource(strings = {"kilted", "jazzy"})
  void goalsThatOthersPursue(String environment) throws Exception {
    talk(
        environment,
        SCRIPT,
        (urbi, peer) -> {
          peer.say("serve /fibonacci count");
          peer.expect("serving");
          urbi.run(
              """
              while ("/fibonacci" not in Ros.actions || Ros.actions["/fibonacci"]["providers"].empty)
                sleep(10ms);
              """);
          assertTrue(
              urbi.holds(
                  "Ros.actions[\"/fibonacci\"] == [\"type\" => \"test_msgs/action/Fibonacci\","
                      + " \"providers\" => [\"/peer\"]]"));
          assertTrue(
              urbi.holds(
                  "Ros.topics.keys.all(function (var name) { name.split(\"/_\").size == 1 })"
                      + " && Ros.services.keys.all(function (var name) { name.split(\"/_\").size == 1 })"
                      + " && !Ros.topics.empty && !Ros.services.empty"));
          urbi.run(
              """
              var Global.fib = Ros.Action.new("/fibonacci")|;
              var Global.steps = []|;
              at (fib.onFeedback?(var feedback)) steps << feedback["sequence"].size;
              """);
          assertTrue(
              urbi.holds("fib.name == \"/fibonacci\" && fib.goalStruct == [\"order\" => 0]"));
          assertTrue(urbi.holds("fib.run([\"order\" => 4]) == [\"sequence\" => [0, 1, 1, 2, 3]]"));
          urbi.run("waituntil (steps == [3, 4, 5]);");
          urbi.refused("fib.run([\"order\" => -1]);", "/fibonacci refuses the goal");
          urbi.refused("fib.run([\"order\" => 0]);", "/fibonacci: the goal was aborted");
          urbi.refused("fib.run([\"order\" => \"many\"]);", "goal.order: a number expected");
          // Whoever is stopped has the server give it up.
          urbi.run(
              """
              var Global.pursuit = Tag.new|;
              steps.clear;
              pursuit: fib.run(["order" => 40]),
              waituntil (!steps.empty);
              pursuit.stop;
              """);
          peer.expect("cancelled");
          urbi.run("timeout (200ms) fib.run([\"order\" => 40]);");
          peer.expect("cancelled");
          urbi.run(
              """
              var Global.goal = fib.send(["order" => 40])|;
              at (goal.status == "canceled") echo("given up");
              waituntil (!goal.feedback.isVoid);
              """);
          assertTrue(urbi.holds("goal.cancel"));
          peer.expect("cancelled");
          urbi.says("given up");
          assertTrue(urbi.holds("goal.result[\"sequence\"].size > 2"));
        });
  }

  @ParameterizedTest
  @ValueSource(strings = {"kilted", "jazzy"})
  void goalsOfOthers(String environment) throws Exception {
    talk(
        environment,
        SCRIPT,
        (urbi, peer) -> {
          urbi.run(OFFERS);
          peer.say("goal /ours 5");
          peer.expect("4 [0, 1, 1, 2, 3, 5] [0, 1, 1, 2, 3, 5]");
          peer.say("goal /ours -1");
          peer.expect("refused");
          peer.say("goal /ours 0");
          peer.expect("6 []");
          peer.say("late /ours 2");
          peer.expect("4 [0, 1, 1]");
          peer.say("cancel /ours 1000");
          peer.expect("0 1 5 [0, 1, 1]");
        });
  }

  @Test
  void aServerThatEndsInTheMiddle() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Scripts here = new Scripts(folder, domain, "src/test/resources/org/urbi/ros");
        Scripts there = new Scripts(folder, domain, "src/test/resources/org/urbi/ros")) {
      there.run(OFFERS);
      here.run("while (\"/ours\" not in Ros.actions) sleep(10ms);");
      here.run("var Global.fib = Ros.Action.new(\"/ours\")|;");
      here.run("var Global.goal = fib.send([\"order\" => 1000])|;");
      here.run("waituntil (!goal.feedback.isVoid);");
      there.run("server.close;");
      // That the server has gone may come before what it said at last.
      here.run("waituntil (goal.status == \"aborted\" || goal.status == \"lost\");");
      here.run("while (\"/ours\" in Ros.actions) sleep(10ms);");
      here.refused("fib.patience = 200ms| fib.run([\"order\" => 1]);", "has gone");
      here.refused("Ros.Action.new(\"/none\");", "there is no action /none: Ros.actions has all");
      here.refused("fib.patience = 0| fib.run([\"order\" => 1]);", "patience: seconds");
      here.refused(
          "Ros.offerAction(\"/x\", \"test_msgs/None\", closure (var goal) {});",
          "there is no type");
    }
  }
}

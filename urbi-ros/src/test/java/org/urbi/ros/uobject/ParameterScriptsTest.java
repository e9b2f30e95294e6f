package org.urbi.ros.uobject;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.ros.rtps.Neighbourhood;

/** Parameters of nodes of ROS 2 in urbiscript. */
class ParameterScriptsTest extends ScriptsFixture {
  private static final String SCRIPT = "parameters.py";

  @ParameterizedTest
  @ValueSource(strings = {"kilted", "jazzy"})
  void othersUseOurs(String environment) throws Exception {
    talk(
        environment,
        SCRIPT,
        (urbi, peer) -> {
          urbi.run("Ros.nodeName = \"robot\";");
          assertTrue(urbi.holds("Ros.name == \"/robot\""));
          peer.say("events /robot");
          peer.expect("listening");
          urbi.run(
              """
              while ("/peer" not in Ros.topics["/parameter_events"]["subscribers"])
                sleep(10ms);
              """);
          urbi.run(
              """
              Ros.setParam("speed", 1);
              Ros.setParam("wheel.names", ["left", "right"]);
              Ros.declareParam("limit", 2,
                ["type" => "double", "description" => "at most", "from" => 0, "to" => 10, "step" => 0.5]);
              Ros.declareParam("serial", "x1", ["readOnly" => true]);
              Ros.declareParam("serial", "x2", [=>]);
              """);
          peer.expect("new speed 1");
          peer.expect("new wheel.names ['left', 'right']");
          peer.expect("new limit 2.0");
          peer.expect("new serial x1");
          peer.say("get /robot speed wheel.names limit none");
          peer.expect("1 ['left', 'right'] 2.0 None");
          peer.say("types /robot speed wheel.names limit none");
          peer.expect("2 9 3 0");
          peer.say("listed /robot");
          peer.expect("limit serial speed use_sim_time wheel.names wheel");
          peer.say("listed /robot wheel");
          peer.expect("wheel.names wheel");
          peer.say("describe /robot limit");
          peer.expect("limit 3 at most False (0.0, 10.0, 0.5)");
          urbi.run(
              "at (Ros.onParam?(var name, var value)) echo(name + \" is \" + value.asString);");
          peer.say(
              "set /robot speed 0.25 limit 11.0 limit \"fast\" none 1 serial \"x3\" limit 2.5");
          // What is sent at the same time arrives by two ways.
          peer.expectInAnyOrder(
              "changed speed 0.25",
              "changed limit 2.5",
              "ok limit: a number from 0.0 to 10.0 expected, in steps of 0.5 limit: a value of the type"
                  + " double expected, not string none is no parameter of /robot serial is read-only ok");
          urbi.says("speed is 0.25");
          urbi.says("limit is 2.5");
          peer.say("atomically /robot speed 7 limit 11.0");
          peer.expect("limit: a number from 0.0 to 10.0 expected, in steps of 0.5");
          assertTrue(urbi.holds("Ros.getParam(\"speed\") == 0.25"));
          urbi.run("Ros.deleteParam(\"speed\");");
          peer.expect("deleted speed 0.25");
          assertTrue(urbi.holds("!Ros.hasParam(\"speed\")"));
        });
  }

  @ParameterizedTest
  @ValueSource(strings = {"kilted", "jazzy"})
  void weUseThoseOfOthers(String environment) throws Exception {
    talk(
        environment,
        SCRIPT,
        (urbi, peer) -> {
          peer.say("declare gain 0.5");
          peer.expect("declared");
          peer.say("declare names [\"a\"]");
          peer.expect("declared");
          urbi.run("while (\"/peer\" not in Ros.nodes) sleep(10ms);");
          assertTrue(urbi.holds("Ros.getParam(\"/peer:gain\") == 0.5"));
          assertTrue(urbi.holds("Ros.getParam(\"/peer:names\") == [\"a\"]"));
          assertTrue(urbi.holds("Ros.hasParam(\"/peer:gain\") && !Ros.hasParam(\"/peer:none\")"));
          assertTrue(urbi.holds("\"gain\" in Ros.paramsOf(\"/peer\")"));
          // A double there, though it is a whole number here.
          urbi.run("Ros.setParam(\"/peer:gain\", 2);");
          peer.say("value gain");
          peer.expect("2.0");
          urbi.refused("Ros.setParam(\"/peer:gain\", \"much\");", "/peer:gain is not set: ");
          urbi.refused("Ros.getParam(\"/peer:none\");", "there is no parameter /peer:none");
        });
  }

  @ParameterizedTest
  @ValueSource(strings = {"kilted", "jazzy"})
  void theTimeOfOthers(String environment) throws Exception {
    talk(
        environment,
        SCRIPT,
        (urbi, peer) -> {
          urbi.run("Ros.nodeName = \"/robot\";");
          peer.say("clock 42 500000000");
          peer.expect("ticking");
          assertTrue(urbi.holds("Ros.time > 1e9 && !Ros.getParam(\"use_sim_time\").asBool"));
          peer.say("set /robot use_sim_time true");
          peer.expect("ok");
          urbi.run("while (Ros.time != 42.5) sleep(10ms);");
          assertTrue(urbi.holds("Ros.stamp == [\"sec\" => 42, \"nanosec\" => 500000000]"));
          urbi.run("Ros.setParam(\"use_sim_time\", false);");
          assertTrue(urbi.holds("Ros.time > 1e9"));
        });
  }

  @Test
  void whatIsWrongIsTold() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Scripts urbi = new Scripts(folder, domain, "")) {
      urbi.refused("Ros.getParam(\"/nobody:x\");", "there is no node /nobody that has parameters");
      urbi.refused("Ros.deleteParam(\"/nobody:x\");", "only /nobody declares and deletes");
      urbi.refused("Ros.setParam(\"x\", [1, \"y\"]);", "a parameter is a number, a string");
      urbi.refused("Ros.setParam(\"\", 1);", "a parameter has a name");
      urbi.refused("Ros.deleteParam(\"x\");", "there is no parameter x");
      urbi.refused("Ros.declareParam(\"x\", 1, [\"color\" => 1]);", "not 'color'");
      urbi.refused("Ros.declareParam(\"x\", 1, [\"from\" => 3]);", "from and to expected");
      urbi.refused("Ros.declareParam(\"x\", 1, [\"type\" => \"int\"]);", "type: bool, integer");
      urbi.refused(
          "Ros.declareParam(\"x\", \"1\", [\"type\" => \"bool\"]);",
          "x: a value of the type bool expected");
      urbi.run("Ros.declareParam(\"flag\", true, [\"type\" => \"bool\"]);");
      assertTrue(urbi.holds("Ros.getParam(\"flag\") == 1"));
      urbi.run("Ros.setParam(Ros.name + \":flag\", false);");
      assertTrue(urbi.holds("Ros.getParam(\"flag\") == 0"));
    }
  }
}

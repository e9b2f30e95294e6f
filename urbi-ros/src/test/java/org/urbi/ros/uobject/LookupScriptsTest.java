package org.urbi.ros.uobject;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.urbi.ros.rtps.Neighbourhood;
import org.urbi.ros.rtps.Peer;

/** Where frames are, in urbiscript. */
class LookupScriptsTest extends ScriptsFixture {
  @Test
  void framesOfOthers() throws Exception {
    try (Neighbourhood domain = new Neighbourhood();
        Peer peer = new Peer("cyclone", domain.domain());
        Scripts urbi = new Scripts(folder, domain, "")) {
      urbi.refused("Ros.lookup(\"odom\", \"laser\", 0, 0.1);", "nobody has told of a frame 'odom'");
      // Whoever waits is told as soon as it is known.
      urbi.run("var Global.found = nil|; found = Ros.lookup(\"odom\", \"laser\", 10.5, 60),");
      peer.say("transforms");
      peer.expect("told");
      urbi.run("waituntil (!found.isNil);");
      assertTrue(
          urbi.holds(
              "found[\"transform\"][\"translation\"] == [\"x\" => 1.5, \"y\" => 0, \"z\" => 0.25]"));
      assertTrue(
          urbi.holds(
              "found[\"header\"] == [\"stamp\" => [\"sec\" => 10, \"nanosec\" => 500000000],"
                  + " \"frame_id\" => \"odom\"]"));
      assertTrue(
          urbi.holds(
              "Ros.lookup(\"odom\", \"base\")[\"header\"][\"stamp\"] == [\"sec\" => 11, \"nanosec\" => 0]"));
      assertTrue(urbi.holds("Ros.frames == [\"base\" => \"odom\", \"laser\" => \"base\"]"));
      urbi.refused(
          "Ros.lookup(\"odom\", \"laser\", [\"sec\" => 20, \"nanosec\" => 0], 0);",
          "where base was in odom is known from 10.000000 to 11.000000, not at 20.000000"
              + " (9.000000 s too late)");
      urbi.refused("Ros.lookup(\"odom\", \"laser\", -1);", "time: seconds, or a stamp");
      urbi.refused("Ros.lookup(\"odom\", \"laser\", 0, -1);", "patience: seconds expected");
    }
  }
}

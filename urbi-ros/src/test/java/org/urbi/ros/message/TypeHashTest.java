package org.urbi.ros.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.urbi.ros.Oracle;

/** The identities of types are those that ROS computes. */
class TypeHashTest {
  @Test
  void sumsOfRosOne() {
    Definitions definitions = Oracle.definitions(Dialect.ROS_1);
    List<String> found = new ArrayList<>();
    List<String> lines = Oracle.lines("md5.txt");
    for (String line : lines) {
      String[] words = line.split(" ");
      String sum =
          words[0].equals("msg")
              ? TypeHash.md5(definitions.message(words[1]))
              : TypeHash.md5(definitions.service(words[1]));
      found.add(words[0] + " " + words[1] + " " + sum);
    }
    assertEquals(String.join("\n", lines), String.join("\n", found));
    assertTrue(found.size() > 120, found.size() + " types");
  }

  @Test
  void hashesOfRosTwo() {
    Definitions definitions = Oracle.definitions(Dialect.ROS_2);
    Map<String, String> computed = new HashMap<>();
    List<String> lines = Oracle.lines("rihs.txt");
    for (String line : lines) {
      String name = line.split(" ")[0];
      // What is derived is a part of that from which it is.
      switch (name.split("/")[1]) {
        case "msg" -> put(computed, definitions.message(name));
        case "srv" -> {
          if (name.indexOf('_', name.lastIndexOf('/')) < 0) {
            put(computed, definitions.service(name).whole());
          }
        }
        default -> {
          if (name.indexOf('_', name.lastIndexOf('/')) < 0) {
            put(computed, ((ActionType.Two) definitions.action(name)).whole());
          }
        }
      }
    }
    List<String> found = new ArrayList<>();
    lines.forEach(line -> found.add(line.split(" ")[0] + " " + computed.get(line.split(" ")[0])));
    assertEquals(String.join("\n", lines), String.join("\n", found));
    assertTrue(found.size() > 230, found.size() + " types");
  }

  private static void put(Map<String, String> all, MessageType whole) {
    all.put(whole.name().toString(), TypeHash.rihs(whole));
    for (MessageDefinition part : whole.referenced().values()) {
      MessageType type = Definitions.link(part, name -> whole.definition(name));
      all.putIfAbsent(part.name().toString(), TypeHash.rihs(type));
    }
  }

  @Test
  void partsOfServicesAndActionsAreTypesByThemselves() {
    Definitions definitions = Oracle.definitions(Dialect.ROS_2);
    Map<String, String> expected = new HashMap<>();
    Oracle.lines("rihs.txt").forEach(line -> expected.put(line.split(" ")[0], line.split(" ")[1]));
    ActionType.Two action = (ActionType.Two) definitions.action("test_msgs/Fibonacci");
    for (MessageType each :
        List.of(
            action.goal(),
            action.sendGoal().request(),
            action.getResult().response(),
            action.feedbackMessage(),
            definitions.service("std_srvs/SetBool").request())) {
      assertEquals(expected.get(each.name().toString()), TypeHash.rihs(each));
    }
  }
}

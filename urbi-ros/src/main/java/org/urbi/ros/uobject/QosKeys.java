package org.urbi.ros.uobject;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UValue;

/** What urbiscript says of the delivery of a topic, by the words that ROS 2 has for it. */
final class QosKeys {
  private static final double NANOSECONDS = 1e9;

  private QosKeys() {}

  /**
   * What is wanted.
   *
   * @param keys {@code reliability}, {@code durability}, {@code depth}, {@code deadline} in
   *     seconds; any of them may be missing
   * @param otherwise for those that are missing
   * @throws RosException if there is another key, or a value that it cannot have
   */
  static Qos of(UDictionary keys, Qos otherwise) {
    boolean reliable = otherwise.reliable();
    boolean kept = otherwise.keptForLate();
    int depth = otherwise.depth();
    Duration deadline = otherwise.deadline();
    boolean asOffered = otherwise.asOffered();
    for (Map.Entry<String, UValue> each : keys.entrySet()) {
      String key = each.getKey();
      UValue value = each.getValue();
      switch (key) {
        case "reliability" -> {
          reliable = choice(key, value, "best_effort", "reliable");
          asOffered = false;
        }
        case "durability" -> {
          kept = choice(key, value, "volatile", "transient_local");
          asOffered = false;
        }
        case "depth" -> depth = (int) number(key, value, Integer.MAX_VALUE);
        case "deadline" ->
            deadline = Duration.ofNanos((long) (number(key, value, 1e9) * NANOSECONDS));
        default ->
            throw new RosException(
                "qos: reliability, durability, depth or deadline expected, not '" + key + "'");
      }
    }
    return new Qos(reliable, kept, depth, deadline, asOffered);
  }

  /**
   * Whether the value is the second of two words.
   *
   * @throws RosException if it is neither
   */
  private static boolean choice(String key, UValue value, String no, String yes) {
    String text = value.getType() == UDataType.DATA_STRING ? value.stringValue() : "";
    if (!List.of(no, yes).contains(text)) {
      throw new RosException("qos: " + key + ": \"" + no + "\" or \"" + yes + "\" expected");
    }
    return text.equals(yes);
  }

  private static double number(String key, UValue value, double most) {
    double number = value.getType() == UDataType.DATA_DOUBLE ? value.doubleValue() : -1;
    if (!(number >= 0 && number <= most)) {
      throw new RosException("qos: " + key + ": a number, 0 or more, expected");
    }
    return number;
  }
}

package org.urbi.ros.graph;

import java.time.Duration;

/**
 * How the messages of a topic are delivered. ROS 1 is always reliable; a topic whose messages are
 * kept for those who come later is "latched" there, and keeps one.
 *
 * @param keptForLate whether who subscribes later gets the last messages
 * @param depth how many messages wait at most; the oldest go first. 0: all wait, up to the limit of
 *     the implementation
 * @param deadline how often a message is to come; zero for no promise
 * @param asOffered whether a subscriber takes what the publishers offer that are there when it
 *     begins to listen, whatever {@code reliable} and {@code keptForLate} say: as in ROS 1, where
 *     that is theirs to choose
 */
public record Qos(
    boolean reliable, boolean keptForLate, int depth, Duration deadline, boolean asOffered) {
  /** What ROS 2 uses unless it is told otherwise. */
  public static final Qos DEFAULT = new Qos(true, false, 10, Duration.ZERO, false);

  /** For sensors: what is lost is not sent again. */
  public static final Qos SENSOR_DATA = new Qos(false, false, 5, Duration.ZERO, false);

  /** For what seldom changes, as maps. */
  public static final Qos LATCHED = new Qos(true, true, 1, Duration.ZERO, false);

  /** A copy with that delivery. */
  public Qos with(boolean isReliable, boolean isKeptForLate) {
    return new Qos(isReliable, isKeptForLate, depth, deadline, false);
  }

  /** A copy in which so many messages wait at most, if all of them wait. */
  public Qos atMost(int most) {
    return depth > 0 ? this : new Qos(reliable, keptForLate, most, deadline, false);
  }
}

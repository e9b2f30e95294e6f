package org.urbi.ros.uobject;

import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.Dialect;

/** Which ROS is meant, by what the environment of a user has. */
final class RosVersion {
  private static final String OURS = "URBI_ROS_VERSION";

  /** ROS 1 has come to its end: there will be no others. */
  private static final Set<String> DISTRIBUTIONS_OF_ONE =
      Set.of(
          "boxturtle",
          "cturtle",
          "diamondback",
          "electric",
          "fuerte",
          "groovy",
          "hydro",
          "indigo",
          "jade",
          "kinetic",
          "lunar",
          "melodic",
          "noetic");

  private RosVersion() {}

  /**
   * What {@code URBI_ROS_VERSION} says; otherwise 1 if {@code ROS_MASTER_URI} names a master, 2 if
   * there is anything that only ROS 2 has, and 1 if there is nothing at all.
   *
   * @throws RosException if {@code URBI_ROS_VERSION} is neither 1 nor 2
   */
  static Dialect of(Map<String, String> environment) {
    String ours = value(environment, OURS);
    if (!ours.isEmpty()) {
      return of(OURS, ours);
    }
    return value(environment, "ROS_MASTER_URI").isEmpty() && isTwo(environment)
        ? Dialect.ROS_2
        : Dialect.ROS_1;
  }

  /**
   * The version with that number.
   *
   * @param what what has that value
   * @throws RosException if there is none
   */
  static Dialect of(String what, String number) {
    return switch (number) {
      case "1" -> Dialect.ROS_1;
      case "2" -> Dialect.ROS_2;
      default -> throw new RosException(what + " is 1 or 2, and is '" + number + "'");
    };
  }

  private static boolean isTwo(Map<String, String> environment) {
    String distribution = value(environment, "ROS_DISTRO");
    return Stream.of("ROS_DOMAIN_ID", "AMENT_PREFIX_PATH", "ROS_AUTOMATIC_DISCOVERY_RANGE")
            .anyMatch(name -> !value(environment, name).isEmpty())
        || value(environment, "ROS_VERSION").equals("2")
        || !distribution.isEmpty() && !DISTRIBUTIONS_OF_ONE.contains(distribution);
  }

  private static String value(Map<String, String> environment, String name) {
    return environment.getOrDefault(name, "").strip();
  }
}

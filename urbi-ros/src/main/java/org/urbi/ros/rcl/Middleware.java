package org.urbi.ros.rcl;

import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.two.TwoNode;
import org.urbi.ros.two.TwoSettings;

/**
 * Which of the two ways a node of ROS 2 goes: that of this program, or that of an installed ROS 2,
 * which is slower and can do more.
 */
public final class Middleware {
  private static final String WAY = "URBI_ROS_MIDDLEWARE";
  private static final String EMBEDDED = "embedded";
  private static final String INSTALLED = "rcl";
  private static final String IMPLEMENTATION = "RMW_IMPLEMENTATION";
  private static final String SECURITY = "ROS_SECURITY_ENABLE";

  /** What names of middleware have in them whose nodes this program reaches by itself. */
  private static final String[] DDS = {"fastrtps", "fastdds", "cyclonedds", "connext", "gurumdds"};

  private Middleware() {}

  /**
   * Makes a node.
   *
   * @param environment what {@code URBI_ROS_MIDDLEWARE} says; without it, {@code
   *     ROS_SECURITY_ENABLE} and {@code RMW_IMPLEMENTATION} tell whether only the installed ROS 2
   *     will do. {@code AMENT_PREFIX_PATH} tells where that is
   * @param people are told what goes wrong and was survived, by threads of the node
   * @throws RosException if that is not possible
   */
  public static Node start(
      Map<String, String> environment, TwoSettings settings, Consumer<String> people) {
    String way = value(environment, WAY);
    return switch (way) {
      case EMBEDDED -> TwoNode.start(settings, people);
      case INSTALLED -> installed(environment, WAY + " is rcl", settings, people);
      case "" -> usual(environment, settings, people);
      default -> throw new RosException(WAY + " is embedded or rcl, and is '" + way + "'");
    };
  }

  private static String value(Map<String, String> environment, String name) {
    return environment.getOrDefault(name, "").strip();
  }

  private static Node usual(
      Map<String, String> environment, TwoSettings settings, Consumer<String> people) {
    // Who wants security is never served without it.
    if (value(environment, SECURITY).equals("true"))
      return installed(environment, SECURITY + " is true", settings, people);
    String implementation = value(environment, IMPLEMENTATION);
    if (implementation.isEmpty() || Stream.of(DDS).anyMatch(implementation::contains))
      return TwoNode.start(settings, people);
    try {
      return installed(environment, IMPLEMENTATION + " is " + implementation, settings, people);
    } catch (RosException e) {
      people.accept(e.getMessage() + "; until then, only nodes with DDS are reached");
      return TwoNode.start(settings, people);
    }
  }

  private static Node installed(
      Map<String, String> environment,
      String reason,
      TwoSettings settings,
      Consumer<String> people) {
    Optional<Installation> found = Installation.of(environment);
    if (found.isEmpty())
      throw new RosException(
          reason
              + ", but no folder of AMENT_PREFIX_PATH has lib/librcl.so: source a ROS 2, or set "
              + WAY
              + "=embedded");
    try {
      return RclNode.start(settings, found.get(), people);
    } catch (RosException e) {
      throw new RosException(reason + ", but " + e.getMessage(), e);
    }
  }
}

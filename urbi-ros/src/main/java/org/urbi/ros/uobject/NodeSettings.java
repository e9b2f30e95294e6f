package org.urbi.ros.uobject;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import org.urbi.ros.graph.Node;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.one.OneNode;
import org.urbi.ros.one.OneSettings;
import org.urbi.ros.rcl.Middleware;
import org.urbi.ros.two.TwoSettings;

/**
 * What was chosen for the node before it is made, so that what is set meanwhile makes no
 * difference.
 *
 * @param name of the node; empty for one that no other process has
 * @param masterUri of ROS 1
 * @param domain of ROS 2
 * @param packagePath where types are defined
 * @param names those that mean others
 * @param environment what else there is, by the variables of the environment
 */
record NodeSettings(
    Dialect dialect,
    String name,
    String masterUri,
    String domain,
    String packagePath,
    Map<String, String> names,
    Map<String, String> environment) {
  static final String MASTER = "ROS_MASTER_URI";
  static final String DOMAIN = "ROS_DOMAIN_ID";

  /** What makes a node of them, on a thread that may wait. */
  interface Maker {
    /**
     * Makes it.
     *
     * @param people are told what goes wrong and was survived, by threads of the node
     * @throws org.urbi.ros.graph.RosException if that is not possible
     */
    Node make(NodeSettings settings, Consumer<String> people);
  }

  /** The variable of the environment that tells where types are defined. */
  static String packages(Dialect dialect) {
    return switch (dialect) {
      case ROS_1 -> "ROS_PACKAGE_PATH";
      case ROS_2 -> "AMENT_PREFIX_PATH";
    };
  }

  /** The node that they describe: see {@link Maker#make}. */
  Node start(Consumer<String> people) {
    Map<String, String> chosen = new HashMap<>(environment);
    chosen.put(MASTER, masterUri);
    chosen.put(DOMAIN, domain);
    chosen.put(packages(dialect), packagePath);
    return switch (dialect) {
      case ROS_1 ->
          OneNode.start(
              OneSettings.of(chosen, ownName(), names),
              there -> people.accept(presence(masterUri, there)));
      case ROS_2 ->
          // Whoever sets packagePath wants other types, and no other middleware.
          Middleware.start(environment, TwoSettings.of(chosen, ownName(), names), people);
    };
  }

  private String ownName() {
    if (!name.isEmpty()) {
      return name;
    }
    ProcessHandle self = ProcessHandle.current();
    long born = self.info().startInstant().map(time -> time.toEpochMilli()).orElse(0L);
    return "urbi_" + born + self.pid();
  }

  private static String presence(String uri, boolean there) {
    return there
        ? "connected to the master " + uri
        : "no master at " + uri + ", looking for it every second (start roscore)";
  }
}

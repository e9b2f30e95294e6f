package org.urbi.ros.graph;

import java.util.List;
import java.util.SortedMap;

/**
 * Who does what, at one time.
 *
 * @param nodes by their full names
 * @param topics by their full names
 * @param services by their full names
 */
public record GraphSnapshot(
    SortedMap<String, NodeInfo> nodes,
    SortedMap<String, TopicInfo> topics,
    SortedMap<String, ServiceInfo> services) {
  /** The full names of what a node has. */
  public record NodeInfo(List<String> publishes, List<String> subscribes, List<String> services) {}

  /**
   * A topic.
   *
   * @param type as its ROS writes it; empty if nobody has said
   * @param publishers the names of nodes
   * @param subscribers the names of nodes
   */
  public record TopicInfo(String type, List<String> publishers, List<String> subscribers) {}

  /**
   * A service.
   *
   * @param type as its ROS writes it; empty if it is not known without asking the service
   * @param providers the names of nodes
   */
  public record ServiceInfo(String type, List<String> providers) {}
}

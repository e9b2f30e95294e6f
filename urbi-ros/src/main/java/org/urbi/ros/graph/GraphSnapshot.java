package org.urbi.ros.graph;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

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

  /**
   * An action.
   *
   * @param type as its ROS writes it
   * @param providers the names of nodes
   */
  public record ActionInfo(String type, List<String> providers) {}

  private static final String SEND_GOAL = "/_action/send_goal";
  private static final String GOAL_TYPE = "_SendGoal";
  private static final String GOAL = "/goal";
  private static final String RESULT = "/result";
  private static final String GOAL_MESSAGE = "ActionGoal";

  /**
   * Actions by their full names: those to whose services of ROS 2, or topics of ROS 1, goals can be
   * sent.
   */
  public SortedMap<String, ActionInfo> actions() {
    SortedMap<String, ActionInfo> all = new TreeMap<>();
    topics.forEach((name, topic) -> {
      if (!name.endsWith(GOAL) || !topic.type().endsWith(GOAL_MESSAGE)) return;
      String action = without(name, GOAL);
      TopicInfo result = topics.get(action + RESULT);
      if (result != null && !result.publishers().isEmpty())
        all.put(action, new ActionInfo(without(topic.type(), GOAL_MESSAGE), result.publishers()));
    });
    services.forEach((name, service) -> {
      if (name.endsWith(SEND_GOAL) && service.type().endsWith(GOAL_TYPE))
        all.put(
            without(name, SEND_GOAL),
            new ActionInfo(without(service.type(), GOAL_TYPE), service.providers()));
    });
    return all;
  }

  private static String without(String text, String end) {
    return text.substring(0, text.length() - end.length());
  }

  /** A copy without what ROS 2 hides from people: names with a part that begins with _. */
  public GraphSnapshot visible() {
    SortedMap<String, NodeInfo> people = new TreeMap<>();
    nodes.forEach((name, node) ->
        people.put(
            name,
            new NodeInfo(
                visible(node.publishes), visible(node.subscribes), visible(node.services))));
    return new GraphSnapshot(people, visible(topics), visible(services));
  }

  private static List<String> visible(List<String> names) {
    return names.stream().filter(GraphSnapshot::isVisible).toList();
  }

  private static <T> SortedMap<String, T> visible(SortedMap<String, T> all) {
    SortedMap<String, T> some = new TreeMap<>(all);
    some.keySet().removeIf(name -> !isVisible(name));
    return some;
  }

  private static boolean isVisible(String name) {
    return !name.contains("/_");
  }
}

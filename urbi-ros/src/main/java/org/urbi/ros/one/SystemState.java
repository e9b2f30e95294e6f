package org.urbi.ros.one;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.GraphSnapshot.NodeInfo;
import org.urbi.ros.graph.GraphSnapshot.ServiceInfo;
import org.urbi.ros.graph.GraphSnapshot.TopicInfo;

/** Makes of a master's state, which lists who publishes, subscribes and serves, a graph. */
final class SystemState {
  private final SortedMap<String, NodeInfo> nodes = new TreeMap<>();
  private final SortedMap<String, TopicInfo> topics = new TreeMap<>();
  private final SortedMap<String, ServiceInfo> services = new TreeMap<>();

  private SystemState(List<?> state, List<?> types) {
    for (Object each : types) {
      List<?> pair = (List<?>) each;
      topics.put((String) pair.get(0), topic((String) pair.get(1)));
    }
    for (Object each : (List<?>) state.get(0)) {
      for (String node : members(each)) {
        node(node).publishes().add(name(each));
        topic(each).publishers().add(node);
      }
    }
    for (Object each : (List<?>) state.get(1)) {
      for (String node : members(each)) {
        node(node).subscribes().add(name(each));
        topic(each).subscribers().add(node);
      }
    }
    for (Object each : (List<?>) state.get(2)) {
      for (String node : members(each)) {
        node(node).services().add(name(each));
        services
            .computeIfAbsent(name(each), any -> new ServiceInfo("", new ArrayList<>()))
            .providers()
            .add(node);
      }
    }
  }

  /**
   * The graph.
   *
   * @param state the answer to {@code getSystemState}
   * @param types the answer to {@code getTopicTypes}
   * @throws ClassCastException if they are something else
   */
  static GraphSnapshot graph(List<?> state, List<?> types) {
    SystemState read = new SystemState(state, types);
    // The master remembers the types of topics that nobody has any more.
    read.topics
        .values()
        .removeIf(each -> each.publishers().isEmpty() && each.subscribers().isEmpty());
    return new GraphSnapshot(read.nodes, read.topics, read.services);
  }

  private static String name(Object entry) {
    return (String) ((List<?>) entry).get(0);
  }

  private static List<String> members(Object entry) {
    return ((List<?>) ((List<?>) entry).get(1)).stream().map(String.class::cast).toList();
  }

  private NodeInfo node(String name) {
    return nodes.computeIfAbsent(
        name, any -> new NodeInfo(new ArrayList<>(), new ArrayList<>(), new ArrayList<>()));
  }

  private static TopicInfo topic(String type) {
    return new TopicInfo(type, new ArrayList<>(), new ArrayList<>());
  }

  private TopicInfo topic(Object entry) {
    return topics.computeIfAbsent(name(entry), any -> topic("*"));
  }
}

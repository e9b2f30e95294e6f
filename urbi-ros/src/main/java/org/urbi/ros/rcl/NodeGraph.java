package org.urbi.ros.rcl;

import java.lang.foreign.Arena;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.GraphSnapshot.NodeInfo;
import org.urbi.ros.graph.GraphSnapshot.ServiceInfo;
import org.urbi.ros.graph.GraphSnapshot.TopicInfo;
import org.urbi.ros.rcl.CFunctions.Structure;

/** Who does what, as {@code rcl} tells it. */
final class NodeGraph {
  private static final long STRINGS = 56;
  private static final long NAMES_AND_TYPES = 64;

  private final Session session;
  private final CFunctions c;

  NodeGraph(Session session) {
    this.session = session;
    c = session.functions();
  }

  static String fullName(String namespace, String name) {
    return namespace.endsWith("/") ? namespace + name : namespace + "/" + name;
  }

  GraphSnapshot snapshot() {
    return session.use(this::read);
  }

  private GraphSnapshot read() {
    SortedMap<String, NodeInfo> nodes = new TreeMap<>();
    SortedMap<String, TopicInfo> topics = new TreeMap<>();
    SortedMap<String, ServiceInfo> services = new TreeMap<>();
    topics()
        .forEach((name, type) ->
            topics.put(name, new TopicInfo(type, new ArrayList<>(), new ArrayList<>())));
    services()
        .forEach((name, type) -> services.put(name, new ServiceInfo(type, new ArrayList<>())));
    for (String[] each : nodes()) {
      String full = fullName(each[1], each[0]);
      List<String> publishes = ofNode("rcl_get_publisher_names_and_types_by_node", each, false);
      List<String> subscribes = ofNode("rcl_get_subscriber_names_and_types_by_node", each, false);
      List<String> serves = ofNode("rcl_get_service_names_and_types_by_node", each);
      nodes.put(full, new NodeInfo(publishes, subscribes, serves));
      for (String topic : publishes)
        if (topics.get(topic) instanceof TopicInfo known) known.publishers().add(full);
      for (String topic : subscribes)
        if (topics.get(topic) instanceof TopicInfo known) known.subscribers().add(full);
      for (String service : serves)
        if (services.get(service) instanceof ServiceInfo known) known.providers().add(full);
    }
    return new GraphSnapshot(nodes, topics, services);
  }

  /** The topics, and the type of each. */
  SortedMap<String, String> topics() {
    return session.use(() ->
        namesAndTypes("rcl_get_topic_names_and_types", session.node(), session.allocator(), false));
  }

  /** The services, and the type of each. */
  SortedMap<String, String> services() {
    return session.use(() ->
        namesAndTypes("rcl_get_service_names_and_types", session.node(), session.allocator()));
  }

  private List<String[]> nodes() {
    try (Arena here = Arena.ofConfined()) {
      MemorySegment names = here.allocate(STRINGS, Long.BYTES);
      MemorySegment spaces = here.allocate(STRINGS, Long.BYTES);
      c.check(
          "rcl_get_node_names", session.node(), new Structure(session.allocator()), names, spaces);
      List<String> first = strings(names);
      List<String> second = strings(spaces);
      c.check("rcutils_string_array_fini", names);
      c.check("rcutils_string_array_fini", spaces);
      List<String[]> all = new ArrayList<>();
      for (int i = 0; i < first.size(); i++) all.add(new String[] {first.get(i), second.get(i)});
      return all;
    }
  }

  private List<String> ofNode(String function, String[] node, Object... more) {
    List<Object> arguments = new ArrayList<>(List.of(session.node(), session.allocator()));
    arguments.addAll(List.of(more));
    arguments.addAll(List.of(node[0], node[1]));
    return new ArrayList<>(namesAndTypes(function, arguments.toArray()).keySet());
  }

  private SortedMap<String, String> namesAndTypes(String function, Object... arguments) {
    SortedMap<String, String> all = new TreeMap<>();
    try (Arena here = Arena.ofConfined()) {
      MemorySegment told = here.allocate(NAMES_AND_TYPES, Long.BYTES);
      Object[] wanted = Arrays.copyOf(arguments, arguments.length + 1);
      wanted[arguments.length] = told;
      // A node may have gone since it was told of.
      if (c.number(function, wanted) != 0) {
        c.run("rcutils_reset_error");
        return all;
      }
      List<String> names = strings(told);
      MemorySegment types = CFunctions.content(told, STRINGS, names.size() * STRINGS);
      for (int i = 0; i < names.size(); i++)
        all.put(
            names.get(i),
            strings(types.asSlice(i * STRINGS, STRINGS)).stream().findFirst().orElse(""));
      c.check("rcl_names_and_types_fini", told);
    }
    return all;
  }

  private static List<String> strings(MemorySegment array) {
    long count = array.get(ValueLayout.JAVA_LONG, 0);
    MemorySegment data = CFunctions.content(array, Long.BYTES, count * Long.BYTES);
    List<String> all = new ArrayList<>();
    for (long i = 0; i < count; i++)
      all.add(CFunctions.text(data.get(ValueLayout.ADDRESS, i * Long.BYTES)));
    return all;
  }
}

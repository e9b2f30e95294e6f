package org.urbi.ros.two;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.GraphSnapshot.NodeInfo;
import org.urbi.ros.graph.GraphSnapshot.ServiceInfo;
import org.urbi.ros.graph.GraphSnapshot.TopicInfo;
import org.urbi.ros.rtps.EndpointInfo;
import org.urbi.ros.rtps.Guid;

/**
 * Who does what, from what participants tell of their writers and readers, and of the nodes that
 * these belong to.
 */
final class TwoGraph {
  private static final String HASH = "typehash=";

  private TwoGraph() {}

  static GraphSnapshot snapshot(Collection<Entities> participants, List<EndpointInfo> endpoints) {
    Map<Guid, String> owners = new HashMap<>();
    Map<String, Work> nodes = new LinkedHashMap<>();
    for (Entities participant : participants) {
      for (Entities.NodeEntities node : participant.nodes()) {
        nodes.put(node.fullName(), new Work());
        node.readers().forEach(guid -> owners.put(guid, node.fullName()));
        node.writers().forEach(guid -> owners.put(guid, node.fullName()));
      }
    }
    Map<String, Place> topics = new TreeMap<>();
    Map<String, Place> services = new TreeMap<>();
    for (EndpointInfo each : endpoints) {
      // Of programs that are no nodes, the topics are known all the same.
      String owner = owners.getOrDefault(each.guid(), "");
      Work work = nodes.getOrDefault(owner, new Work());
      String topic = Mangling.topicOf(each.topic());
      String service = Mangling.serviceOf(each.topic());
      if (!topic.isEmpty()) {
        Place place =
            topics.computeIfAbsent(topic, name -> new Place(Mangling.typeOf(each.type())));
        (each.isWriter() ? place.givers : place.takers).add(owner);
        (each.isWriter() ? work.publishes : work.subscribes).add(topic);
      } else if (!service.isEmpty() && !each.isWriter()) {
        services
            .computeIfAbsent(service, name -> new Place(Mangling.serviceTypeOf(each.type())))
            .givers
            .add(owner);
        work.services.add(service);
      }
    }
    SortedMap<String, NodeInfo> nodeInfos = new TreeMap<>();
    nodes.forEach((name, work) -> nodeInfos.put(name, work.info()));
    SortedMap<String, TopicInfo> topicInfos = new TreeMap<>();
    topics.forEach((name, place) ->
        topicInfos.put(name, new TopicInfo(place.type, known(place.givers), known(place.takers))));
    SortedMap<String, ServiceInfo> serviceInfos = new TreeMap<>();
    services.forEach(
        (name, place) -> serviceInfos.put(name, new ServiceInfo(place.type, known(place.givers))));
    return new GraphSnapshot(nodeInfos, topicInfos, serviceInfos);
  }

  private static List<String> known(TreeSet<String> names) {
    return names.stream().filter(name -> !name.isEmpty()).toList();
  }

  /** What tells others which version of a type is meant. */
  static byte[] userData(String hash) {
    return (HASH + hash + ";").getBytes(StandardCharsets.UTF_8);
  }

  /** The hash of the type of that writer or reader; empty if it does not tell. */
  static String hashOf(EndpointInfo endpoint) {
    for (String each : new String(endpoint.userData(), StandardCharsets.UTF_8).split(";"))
      if (each.startsWith(HASH)) return each.substring(HASH.length());
    return "";
  }

  private static final class Place {
    final String type;
    final TreeSet<String> givers = new TreeSet<>();
    final TreeSet<String> takers = new TreeSet<>();

    Place(String type) {
      this.type = type;
    }
  }

  private static final class Work {
    final TreeSet<String> publishes = new TreeSet<>();
    final TreeSet<String> subscribes = new TreeSet<>();
    final TreeSet<String> services = new TreeSet<>();

    NodeInfo info() {
      return new NodeInfo(
          new ArrayList<>(publishes), new ArrayList<>(subscribes), new ArrayList<>(services));
    }
  }
}

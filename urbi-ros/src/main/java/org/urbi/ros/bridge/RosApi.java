package org.urbi.ros.bridge;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.Templates;

/** The services by which clients ask for the graph: those of ROS's node rosapi. */
final class RosApi {
  static final String PREFIX = "rosapi/";
  private static final long SECOND = 1_000_000_000;

  private final Node node;

  RosApi(Node node) {
    this.node = node;
  }

  /**
   * Answers one of them.
   *
   * @throws BridgeException if there is none of that name
   */
  CompletionStage<Map<String, @Nullable Object>> answer(
      String name, Map<String, @Nullable Object> arguments) {
    Operation asked = new Operation(arguments);
    return switch (name) {
      case "get_time" -> CompletableFuture.completedFuture(Map.of("time", now()));
      case "get_ros_version" ->
          CompletableFuture.completedFuture(Map.of("version", node.version().version()));
      case "topics",
          "topics_for_type",
          "topic_type",
          "publishers",
          "subscribers",
          "services",
          "services_for_type",
          "service_type",
          "service_providers",
          "service_node",
          "nodes",
          "node_details" ->
          node.graph().thenApply(graph -> graph(name, asked, graph.visible()));
      case "action_servers" ->
          node.graph().thenApply(graph -> one("action_servers", graph.actions().keySet()));
      case "get_param" ->
          node.parameters()
              .get(asked.needed("name"))
              .thenApply(value -> one("value", value.toString()));
      case "has_param" ->
          node.parameters().has(asked.needed("name")).thenApply(there -> one("exists", there));
      case "get_param_names" -> node.parameters().names().thenApply(names -> one("names", names));
      case "delete_param" ->
          node.parameters().delete(asked.needed("name")).thenApply(done -> new LinkedHashMap<>());
      default ->
          CompletableFuture.failedFuture(
              new RosException("there is no service /" + PREFIX + name + " here"));
    };
  }

  private static Map<String, @Nullable Object> one(String key, Object value) {
    Map<String, @Nullable Object> map = new LinkedHashMap<>();
    map.put(key, value);
    return map;
  }

  private Map<String, Object> now() {
    long now = node.now();
    boolean one = node.version() == Dialect.ROS_1;
    return Map.of(
        one ? "secs" : Templates.SECONDS,
        now / SECOND,
        one ? "nsecs" : Templates.NANOSECONDS,
        now % SECOND);
  }

  private Map<String, @Nullable Object> graph(String name, Operation asked, GraphSnapshot graph) {
    return switch (name) {
      case "topics" -> {
        Map<String, @Nullable Object> all = one("topics", graph.topics().keySet());
        all.put(
            "types", graph.topics().values().stream().map(GraphSnapshot.TopicInfo::type).toList());
        yield all;
      }
      case "topics_for_type" -> {
        List<String> names = new ArrayList<>();
        graph
            .topics()
            .forEach((topic, info) -> {
              if (info.type().equals(asked.text("type"))) {
                names.add(topic);
              }
            });
        yield one("topics", names);
      }
      case "topic_type" -> one("type", topic(asked, graph).type());
      case "publishers" -> one("publishers", topic(asked, graph).publishers());
      case "subscribers" -> one("subscribers", topic(asked, graph).subscribers());
      case "services" -> one("services", graph.services().keySet());
      case "services_for_type" -> {
        List<String> names = new ArrayList<>();
        graph
            .services()
            .forEach((service, info) -> {
              if (info.type().equals(asked.text("type"))) {
                names.add(service);
              }
            });
        yield one("services", names);
      }
      case "service_type" -> one("type", service(asked, graph).type());
      case "service_providers" -> one("providers", service(asked, graph).providers());
      case "service_node" ->
          one("node", service(asked, graph).providers().stream().findFirst().orElse(""));
      case "nodes" -> one("nodes", graph.nodes().keySet());
      case "node_details" -> {
        GraphSnapshot.NodeInfo info =
            graph
                .nodes()
                .getOrDefault(
                    asked.needed("node"),
                    new GraphSnapshot.NodeInfo(List.of(), List.of(), List.of()));
        Map<String, @Nullable Object> all = one("subscribing", info.subscribes());
        all.put("publishing", info.publishes());
        all.put("services", info.services());
        yield all;
      }
      default -> throw new BridgeException("there is no " + name);
    };
  }

  private GraphSnapshot.TopicInfo topic(Operation asked, GraphSnapshot graph) {
    GraphSnapshot.TopicInfo info = graph.topics().get(node.resolve(asked.needed("topic")));
    return info == null ? new GraphSnapshot.TopicInfo("", List.of(), List.of()) : info;
  }

  private GraphSnapshot.ServiceInfo service(Operation asked, GraphSnapshot graph) {
    GraphSnapshot.ServiceInfo info = graph.services().get(node.resolve(asked.needed("service")));
    return info == null ? new GraphSnapshot.ServiceInfo("", List.of()) : info;
  }
}

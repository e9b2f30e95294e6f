package org.urbi.ros.uobject;

import org.urbi.ros.graph.GraphSnapshot;
import urbi.UDictionary;

/** A graph as Dictionaries (manual, "Ros": nodes, topics, services; and actions). */
final class Listings {
  private static final String SEND_GOAL = "/_action/send_goal";
  private static final String GOAL_TYPE = "_SendGoal";

  private Listings() {}

  static UDictionary nodes(GraphSnapshot graph) {
    UDictionary all = new UDictionary();
    graph
        .nodes()
        .forEach((name, node) ->
            all.with(
                name,
                new UDictionary()
                    .with("publish", node.publishes())
                    .with("subscribe", node.subscribes())
                    .with("services", node.services())));
    return all;
  }

  static UDictionary topics(GraphSnapshot graph) {
    UDictionary all = new UDictionary();
    graph
        .topics()
        .forEach((name, topic) ->
            all.with(
                name,
                new UDictionary()
                    .with("publishers", topic.publishers())
                    .with("subscribers", topic.subscribers())
                    .with("type", topic.type())));
    return all;
  }

  static UDictionary services(GraphSnapshot graph) {
    UDictionary all = new UDictionary();
    graph.services().forEach((name, service) -> all.with(name, service.providers()));
    return all;
  }

  /** Actions, by the service to which their goals are sent. */
  static UDictionary actions(GraphSnapshot graph) {
    UDictionary all = new UDictionary();
    graph
        .services()
        .forEach((name, service) -> {
          if (name.endsWith(SEND_GOAL) && service.type().endsWith(GOAL_TYPE)) {
            all.with(
                without(name, SEND_GOAL),
                new UDictionary()
                    .with("type", without(service.type(), GOAL_TYPE))
                    .with("providers", service.providers()));
          }
        });
    return all;
  }

  private static String without(String text, String end) {
    return text.substring(0, text.length() - end.length());
  }
}

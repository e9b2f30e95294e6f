package org.urbi.ros.uobject;

import org.urbi.ros.graph.GraphSnapshot;
import urbi.UDictionary;

/** A graph as Dictionaries (manual, "Ros": nodes, topics, services; and actions). */
final class Listings {
  private Listings() {}

  static UDictionary nodes(GraphSnapshot graph) {
    UDictionary all = new UDictionary();
    graph
        .visible()
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
        .visible()
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
    graph.visible().services().forEach((name, service) -> all.with(name, service.providers()));
    return all;
  }

  static UDictionary actions(GraphSnapshot graph) {
    UDictionary all = new UDictionary();
    graph
        .actions()
        .forEach((name, action) ->
            all.with(
                name,
                new UDictionary()
                    .with("type", action.type())
                    .with("providers", action.providers())));
    return all;
  }
}

package org.urbi.ros.rcl;

import java.lang.foreign.MemorySegment;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.rcl.Endpoints.Endpoint;
import org.urbi.ros.two.Reports;
import urbi.UDictionary;

/** What this node says on a topic. */
final class RclPublisher implements Publisher {
  /** Nothing waits for slow subscribers: where all are wanted, there is an end somewhere. */
  private static final int MOST = 1000;

  private final RclNode node;
  private final String topic;
  private final MessageSupport support;
  private final Delivery delivery;
  private final Listener listener;
  private final Reports troubles;
  private final Entity entity;
  private final Matches matches;
  private final Runnable stopsSeeking;

  /** The subscribers that were told of, by what identifies each; for the thread of the graph. */
  private final Map<String, String> subscribed = new HashMap<>();

  RclPublisher(RclNode node, String topic, MessageType type, Qos qos, Listener listener) {
    this.node = node;
    this.topic = topic;
    this.listener = listener;
    troubles = new Reports(listener::failed);
    support = node.support(type);
    delivery = new Delivery(qos.atMost(MOST));
    entity = new Entity(node.session(), "publisher", support.handle(), topic, delivery);
    matches = new Matches(node.session(), entity, node.arrivals());
    stopsSeeking = node.seek(this::look);
    node.opened(this);
  }

  private void look() {
    List<Endpoint> there = Endpoints.subscriptions(node.session(), topic);
    Set<String> present = there.stream().map(Endpoint::id).collect(Collectors.toSet());
    for (String each : List.copyOf(subscribed.keySet()))
      if (!present.contains(each)) listener.disconnected(subscribed.remove(each));
    int connected = subscribers();
    for (Endpoint each : there) {
      // Which node it is will be told.
      if (each.node().isEmpty() || hasProblem(each)) continue;
      // Who is told of as a subscriber hears from now on.
      if (subscribed.size() < connected && subscribed.putIfAbsent(each.id(), each.node()) == null)
        listener.connected(each.node());
    }
  }

  private boolean hasProblem(Endpoint other) {
    if (node.isOfAnotherType(topic, other, "subscribes to", type())) return true;
    String lacking = delivery.offer().lacks(other.offer());
    if (lacking.isEmpty()) return false;
    troubles.tell(other.node() + " asks for " + lacking + " that is not offered here");
    return true;
  }

  @Override
  public String topic() {
    return topic;
  }

  @Override
  public MessageType type() {
    return support.type();
  }

  @Override
  public void publish(UDictionary message) {
    byte[] bytes = support.encode(message);
    entity.use(memory -> {
      entity.bytes().put(bytes);
      node.session()
          .functions()
          .check(
              "rcl_publish_serialized_message", memory, entity.bytes().array(), MemorySegment.NULL);
    });
  }

  @Override
  public int subscribers() {
    return entity.count("rcl_publisher_get_subscription_count");
  }

  @Override
  public void close() {
    stopsSeeking.run();
    matches.close();
    entity.close();
    node.closed(this);
  }
}

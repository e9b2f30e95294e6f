package org.urbi.ros.rcl;

import java.lang.foreign.MemorySegment;
import java.nio.ByteBuffer;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.codec.CodecException;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.DefinitionException;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.rcl.Endpoints.Endpoint;
import org.urbi.ros.two.Reports;
import urbi.UDictionary;

/** What this node hears on a topic; its type is that of the first publisher, if it was not said. */
final class RclSubscription implements Subscription {
  /** {@code rmw_message_info_t}, and more. */
  private static final long INFO = 256;

  /** After so many, others have their turn. */
  private static final int AT_ONCE = 100;

  private final RclNode node;
  private final String topic;
  private final Delivery delivery;
  private final Listener listener;
  private final Reports troubles;
  private final Runnable stopsSeeking;
  private @Nullable Open open;
  private boolean closed;

  RclSubscription(
      RclNode node, String topic, @Nullable MessageType type, Qos qos, Listener listener) {
    this.node = node;
    this.topic = topic;
    this.listener = listener;
    delivery = new Delivery(qos);
    troubles = new Reports(listener::failed);
    if (type != null) open = new Open(type);
    stopsSeeking = node.seek(this::look);
    node.opened(this);
    if (type == null) look();
  }

  private void look() {
    for (Endpoint each : Endpoints.publishers(node.session(), topic)) {
      Open present = opened(each);
      if (present != null && !each.node().isEmpty()) compare(each, present.support.type());
    }
  }

  private @Nullable Open opened(Endpoint publisher) {
    MessageType type;
    synchronized (this) {
      if (closed || open != null) return open;
      try {
        type = node.definitions().message(publisher.type());
        open = new Open(type);
      } catch (DefinitionException | RosException e) {
        troubles.tell(topic, e);
        return null;
      }
    }
    listener.typed(type);
    return open;
  }

  private void compare(Endpoint other, MessageType own) {
    if (node.isOfAnotherType(topic, other, "publishes", own)) return;
    String lacking = other.offer().lacks(delivery.offer());
    if (!lacking.isEmpty())
      troubles.tell(other.node() + " does not offer the " + lacking + " that is asked for");
  }

  @Override
  public String topic() {
    return topic;
  }

  @Override
  public synchronized int publishers() {
    return open == null ? 0 : open.entity.count("rcl_subscription_get_publisher_count");
  }

  @Override
  public void close() {
    stopsSeeking.run();
    synchronized (this) {
      closed = true;
      if (open != null) open.close();
      open = null;
    }
    node.closed(this);
  }

  /** What there is when the type is known. */
  private final class Open {
    private final MessageSupport support;
    private final Entity entity;
    private final MemorySegment info;
    private final Arrivals.Source source;

    Open(MessageType type) {
      support = node.support(type);
      entity = new Entity(node.session(), "subscription", support.handle(), topic, delivery);
      info = entity.allocate(INFO);
      // Where all are wanted, who listens may have us wait, but not all others of this node.
      boolean isPatient = delivery.qos().depth() == 0;
      source =
          isPatient
              ? node.arrivals().patientSource(this::take)
              : node.arrivals().source(this::take);
      entity.hear(source, "message");
    }

    private void take() {
      for (int i = 0; i < AT_ONCE; i++) {
        byte[] bytes = next();
        if (bytes.length == 0) return;
        received(bytes);
      }
      source.ring();
    }

    /** The next message; no bytes at all if there is none. */
    private byte[] next() {
      byte[][] taken = {{}};
      entity.use(memory -> {
        SerializedBytes bytes = entity.bytes();
        if (entity.take(
            "rcl_take_serialized_message", memory, bytes.array(), info, MemorySegment.NULL))
          taken[0] = bytes.get();
      });
      return taken[0];
    }

    private void received(byte[] bytes) {
      if (listener.takes(ByteBuffer.wrap(bytes))) return;
      UDictionary message;
      try {
        message = support.decode(bytes);
      } catch (CodecException e) {
        troubles.tell("what comes is no " + support.type().name() + ": " + e.getMessage());
        return;
      }
      listener.received(message);
    }

    void close() {
      source.close();
      entity.close();
    }
  }
}

package org.urbi.ros.uobject;

import static java.util.Objects.requireNonNull;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.FieldPath;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.ValueException;
import urbi.UDictionary;
import urbi.UEvent;
import urbi.UObject;
import urbi.UValue;

/**
 * A field of a topic that urbiscript wants to have, the newest one, at a rate at most: nothing else
 * of the messages reaches the kernel. {@code Ros.input} in {@code ros.u} leads it to a variable.
 */
public final class RosInput extends UObject implements MessageReceiver, AutoCloseable {
  static {
    UStart(RosInput.class);
  }

  private final UEvent onValue = new UEvent();
  private volatile @Nullable Delivery<UValue> delivery;
  private @Nullable Subscription subscription;
  private boolean closed;
  private volatile String trouble = "";

  public RosInput(String name) {
    super(name);
    UBindEvent(onValue, "onValue");
    UBindFunction("begin");
  }

  /**
   * Begins to listen.
   *
   * @param typeName empty for the type of those who publish already
   * @param rate times a second at most; 0 for each message
   */
  public CompletionStage<Void> begin(String topic, String field, String typeName, double rate) {
    FieldPath path = FieldPath.of(field);
    Pace pace = new Pace(rate, () -> MessageReceiver.soon(this));
    Delivery<UValue> fields = new Delivery<>(pace::want);
    delivery = fields;
    return Ros.of(this).thenCompose(node -> open(node, topic, typeName, path, fields));
  }

  private CompletionStage<Void> open(
      Node node, String topic, String typeName, FieldPath path, Delivery<UValue> fields) {
    String full = node.resolve(topic);
    if (!typeName.isEmpty()) {
      MessageType type = node.definitions().message(typeName);
      path.check(type);
      return node.prepared(type)
          .thenCompose(ready -> {
            listen(node, full, type, path, fields);
            return node.settled();
          });
    }
    CompletionStage<String> known = node.typeOf(full);
    return known.thenCompose(name -> {
      listen(node, full, null, path, fields);
      return CompletableFuture.completedFuture(null);
    });
  }

  private synchronized void listen(
      Node node,
      String topic,
      @Nullable MessageType type,
      FieldPath path,
      Delivery<UValue> fields) {
    Qos newest = new Qos(true, false, 1, Qos.DEFAULT.deadline(), true);
    if (closed) {
      throw new RosException(topic + " is not wanted any more");
    }
    subscription =
        node.subscribe(
            topic,
            type,
            newest,
            new Subscription.Listener() {
              @Override
              public void received(UDictionary message) {
                try {
                  fields.offer(path.get(message));
                } catch (ValueException e) {
                  failed(requireNonNull(e.getMessage(), "it always says why"));
                }
              }

              @Override
              public void typed(MessageType told) {
                try {
                  path.check(told);
                } catch (ValueException e) {
                  failed(requireNonNull(e.getMessage(), "it always says why"));
                }
              }

              @Override
              public void failed(String reason) {
                tell(topic, reason);
              }
            });
  }

  /** What is wrong with each message is said once. */
  private void tell(String topic, String reason) {
    if (!reason.equals(trouble)) {
      trouble = reason;
      getUContext().report("ROS: " + topic + ": " + reason);
    }
  }

  @Override
  public void take() {
    Delivery<UValue> fields = requireNonNull(delivery, "nothing comes before there is one");
    fields.take(onValue::emit);
  }

  /** Ends listening. */
  @Override
  public synchronized void close() {
    closed = true;
    Subscription present = subscription;
    subscription = null;
    Delivery<UValue> fields = delivery;
    if (fields != null) {
      fields.end();
    }
    if (present != null) {
      present.close();
    }
  }
}

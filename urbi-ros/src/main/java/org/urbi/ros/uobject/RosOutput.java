package org.urbi.ros.uobject;

import static java.util.Objects.requireNonNull;

import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.FieldPath;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.ValueException;
import urbi.UDictionary;
import urbi.UObject;
import urbi.UValue;

/**
 * A field of the messages of a topic that urbiscript sets, all others being what they are in a new
 * message. At a rate at most, the newest value being sent. {@code Ros.output} in {@code ros.u}
 * makes one of a variable.
 */
public final class RosOutput extends UObject implements AutoCloseable {
  static {
    UStart(RosOutput.class);
  }

  private @Nullable Publisher publisher;
  private @Nullable FieldPath path;
  private volatile @Nullable Pace pace;
  private @Nullable UValue value;
  private String trouble = "";
  private boolean closed;

  public RosOutput(String name) {
    super(name);
    UBindFunctions("begin", "tell");
  }

  /**
   * Offers the messages.
   *
   * @param rate times a second at most; 0 for each value
   */
  public CompletionStage<Void> begin(String topic, String typeName, String field, double rate) {
    Pace wanted = new Pace(rate, this::send);
    FieldPath path = FieldPath.of(field);
    return Ros.of(this)
        .thenCompose(node -> {
          MessageType type = node.definitions().message(typeName);
          path.check(type);
          // A list that is too short for the field is an error now, and not with each value.
          path.get(Templates.of(type));
          return node.prepared(type).thenCompose(ready -> open(node, topic, type, path, wanted));
        });
  }

  private synchronized CompletionStage<Void> open(
      Node node, String topic, MessageType type, FieldPath wanted, Pace rate) {
    if (closed) {
      throw new RosException(topic + " is not wanted any more");
    }
    path = wanted;
    pace = rate;
    publisher = node.advertise(topic, type, Qos.DEFAULT, new Publisher.Listener() {});
    return node.settled();
  }

  /** Has a value sent. */
  public void tell(UValue newest) {
    synchronized (this) {
      value = newest;
    }
    requireNonNull(pace, "made by begin").want();
  }

  private synchronized void send() {
    Publisher present = publisher;
    if (present == null) {
      return;
    }
    UDictionary message = Templates.of(present.type());
    try {
      requireNonNull(path, "made with the publisher")
          .put(message, requireNonNull(value, "nothing is sent without one"));
      present.publish(message);
      trouble = "";
    } catch (ValueException | RosException e) {
      // Said once: a value that is wrong is often wrong again.
      String reason = String.valueOf(e.getMessage());
      if (!reason.equals(trouble)) {
        trouble = reason;
        getUContext().report("ROS: " + present.topic() + ": not sent: " + reason);
      }
    }
  }

  /** Ends. */
  @Override
  public synchronized void close() {
    closed = true;
    Publisher present = publisher;
    publisher = null;
    if (present != null) {
      present.close();
    }
  }
}

package org.urbi.ros.bridge;

import java.nio.ByteBuffer;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.time.SteadyClock;
import urbi.UDictionary;

/** The topics that one client hears, and those on which it speaks. */
final class Topics implements AutoCloseable {
  private static final int MOST = 1000;
  private static final String CBOR = "cbor";
  private static final String CBOR_RAW = "cbor-raw";
  private static final List<String> COMPRESSIONS = List.of("none", "png", CBOR, CBOR_RAW);

  private final Node node;
  private final Replies replies;
  private final Map<String, Publisher> publishers = new LinkedHashMap<>();

  /** By the identity that the client has given, and the topic. */
  private final Map<String, Heard> heard = new LinkedHashMap<>();

  Topics(Node node, Replies replies) {
    this.node = node;
    this.replies = replies;
  }

  // ------------------------------------------------------------------ speaking

  synchronized void advertise(Operation operation) {
    String topic = node.resolve(operation.needed("topic"));
    MessageType type = node.definitions().message(operation.needed("type"));
    Publisher known = publishers.get(topic);
    if (known != null) {
      if (!known.type().name().equals(type.name())) {
        throw new BridgeException(
            topic + " is advertised already, as " + known.type().name().in(node.version()));
      }
      return;
    }
    open(topic, type, operation.truth("latch"));
  }

  private Publisher open(String topic, MessageType type, boolean latch) {
    if (publishers.size() >= MOST) {
      throw new BridgeException("too many topics");
    }
    Qos qos = new Qos(true, latch, latch ? 1 : 100, Qos.DEFAULT.deadline(), false);
    Publisher made =
        node.advertise(
            topic,
            type,
            qos,
            new Publisher.Listener() {
              @Override
              public void failed(String reason) {
                replies.status("warning", topic + ": " + reason, null);
              }
            });
    publishers.put(topic, made);
    return made;
  }

  synchronized void unadvertise(Operation operation) {
    Publisher known = publishers.remove(node.resolve(operation.needed("topic")));
    if (known == null) {
      throw new BridgeException(operation.text("topic") + " is not advertised");
    }
    known.close();
  }

  /** Sends a message; a topic that the others use already need not be advertised. */
  void publish(Operation operation) {
    String topic = node.resolve(operation.needed("topic"));
    Publisher known;
    synchronized (this) {
      known = publishers.get(topic);
    }
    if (known != null) {
      publish(known, operation);
      return;
    }
    node.typeOf(topic)
        .thenAccept(name -> {
          Publisher made;
          synchronized (this) {
            made = publishers.get(topic);
            if (made == null) {
              made = open(topic, node.definitions().message(name), operation.truth("latch"));
            }
          }
          publish(made, operation);
        })
        .exceptionally(failure -> {
          replies.failed(operation, failure);
          return null;
        });
  }

  private static void publish(Publisher publisher, Operation operation) {
    publisher.publish(JsonMessages.message(operation.object("msg"), publisher.type()));
  }

  // ------------------------------------------------------------------ hearing

  synchronized void subscribe(Operation operation) {
    String topic = node.resolve(operation.needed("topic"));
    String name = operation.text("type");
    MessageType type = name.isEmpty() ? null : node.definitions().message(name);
    if (heard.size() >= MOST) {
      throw new BridgeException("too many subscriptions");
    }
    String compression = operation.text("compression");
    if (!compression.isEmpty() && !COMPRESSIONS.contains(compression)) {
      replies.status(
          "warning",
          "compression '" + compression + "' is not known: " + String.join(", ", COMPRESSIONS),
          operation.id());
    }
    Heard made = new Heard(topic, operation, type);
    Heard before = heard.put(key(operation.id(), topic), made);
    if (before != null) {
      before.close();
    }
    made.open(type);
  }

  private static String key(@Nullable Object id, String topic) {
    return topic + " " + id;
  }

  synchronized void unsubscribe(Operation operation) {
    String topic = node.resolve(operation.needed("topic"));
    boolean found = false;
    for (Iterator<Heard> each = heard.values().iterator(); each.hasNext(); ) {
      Heard one = each.next();
      boolean meant = operation.id() == null || operation.id().equals(one.operation.id());
      if (one.topic.equals(topic) && meant) {
        each.remove();
        one.close();
        found = true;
      }
    }
    if (!found) {
      throw new BridgeException(topic + " is not subscribed");
    }
  }

  @Override
  public synchronized void close() {
    heard.values().forEach(Heard::close);
    heard.clear();
    publishers.values().forEach(Publisher::close);
    publishers.clear();
  }

  /** A topic that the client hears, with what it has said about it. */
  private final class Heard implements Subscription.Listener {
    final String topic;
    final Operation operation;
    private final long pause;
    private volatile @Nullable MessageType type;
    private @Nullable Subscription subscription;
    private boolean begun;
    private long next;

    Heard(String topic, Operation operation, @Nullable MessageType type) {
      this.topic = topic;
      this.operation = operation;
      this.type = type;
      pause = TimeUnit.MILLISECONDS.toNanos(operation.count("throttle_rate"));
    }

    void open(@Nullable MessageType known) {
      int depth = operation.count("queue_length");
      Qos qos = new Qos(true, false, depth == 0 ? 100 : depth, Qos.DEFAULT.deadline(), true);
      subscription = node.subscribe(topic, known, qos, this);
    }

    void close() {
      if (subscription != null) {
        subscription.close();
      }
    }

    @Override
    public boolean takes(ByteBuffer sent) {
      if (!operation.text("compression").equals(CBOR_RAW)) {
        return false;
      }
      if (isDue()) {
        byte[] bytes = new byte[sent.remaining()];
        sent.get(bytes);
        byte[] told = CborMessages.raw(operation.text("topic"), bytes, node.now());
        replies.publish(told, operation, this);
      }
      return true;
    }

    @Override
    public void received(UDictionary message) {
      MessageType known = type;
      if (known == null || !isDue()) {
        return;
      }
      String name = operation.text("topic");
      if (operation.text("compression").equals(CBOR)) {
        replies.publish(CborMessages.publication(name, message, known), operation, this);
        return;
      }
      Map<String, @Nullable Object> out = new LinkedHashMap<>();
      out.put("op", "publish");
      out.put("topic", name);
      out.put("msg", JsonMessages.json(message, known));
      replies.publish(out, operation, this);
    }

    /** Whether the client wants one more already. */
    private boolean isDue() {
      long now = SteadyClock.nanoseconds();
      if (begun && now - next < 0) {
        return false;
      }
      begun = true;
      next = now + pause;
      return true;
    }

    @Override
    public void typed(MessageType told) {
      type = told;
    }

    @Override
    public void failed(String reason) {
      replies.status("warning", topic + ": " + reason, operation.id());
    }
  }
}

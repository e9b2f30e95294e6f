package org.urbi.ros.uobject;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.DefinitionException;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UEvent;
import urbi.UObject;
import urbi.UValue;
import urbi.UVar;

/** A topic to which urbiscript listens, or on which it speaks (manual, "Ros.Topic"). */
public final class RosTopic extends UObject implements MessageReceiver, AutoCloseable {
  static {
    UStart(RosTopic.class);
  }

  /** Seconds in which a publisher has to tell its type, if nobody else knows that. */
  private static final int PATIENCE = 5;

  private static final int DEFAULT_DEPTH = 100;

  private final UEvent onMessage = new UEvent();
  private final UEvent onConnect = new UEvent();
  private final UEvent onDisconnect = new UEvent();
  private final UVar last = new UVar();
  private final UVar depth = new UVar();
  private final UVar latch = new UVar();
  private final UVar qos = new UVar();
  private final Delivery<UDictionary> delivery = new Delivery<>(() -> MessageReceiver.soon(this));

  private volatile @Nullable Node node;
  private volatile String topic = "";
  private volatile @Nullable MessageType type;
  private volatile @Nullable Subscription subscription;
  private volatile @Nullable Publisher publisher;

  public RosTopic(String name) {
    super(name);
    UBindEvent(onMessage, "onMessage");
    UBindEvent(onConnect, "onConnect");
    UBindEvent(onDisconnect, "onDisconnect");
    UBindVars(last, "last", depth, "depth", latch, "latch", qos, "qos");
    depth.setValue(DEFAULT_DEPTH);
    latch.setValue(0);
    qos.setValue(new UValue(new UDictionary()));
    UBindFunctions(
        "init",
        "name",
        "structure",
        "subscriberCount",
        "subscribe",
        "subscribeAs",
        "unsubscribe",
        "advertise",
        "publish",
        "unadvertise");
    bind("<<", this::publish);
  }

  /** Chooses the topic; may be called again as long as it is neither heard nor advertised. */
  public CompletionStage<Void> init(String name) {
    idle();
    return Ros.of(this)
        .thenAccept(known -> {
          node = known;
          topic = known.resolve(name);
        });
  }

  private Node node() {
    Node known = node;
    if (known == null) {
      throw new RosException("the topic has no name: init");
    }
    return known;
  }

  private void idle() {
    if (subscription != null) {
      throw new RosException(topic + " is subscribed already: unsubscribe first");
    }
    if (publisher != null) {
      throw new RosException(topic + " is advertised already: unadvertise first");
    }
  }

  /** The full name of the topic. */
  public String name() {
    return topic;
  }

  /** A new message of the type of the topic. */
  public UDictionary structure() {
    MessageType known = type;
    if (known == null) {
      throw new RosException("the type is known when " + topic + " is subscribed or advertised");
    }
    return Templates.of(known);
  }

  /** How many subscribe to the topic. */
  public CompletionStage<Integer> subscriberCount() {
    Publisher own = publisher;
    if (own != null) {
      return CompletableFuture.completedFuture(own.subscribers());
    }
    return info().thenApply(info -> info == null ? 0 : info.subscribers().size());
  }

  /** What is known of the topic; null if nothing is. */
  private CompletableFuture<GraphSnapshot.@Nullable TopicInfo> info() {
    return node().graph().thenApply(graph -> graph.topics().get(topic));
  }

  /** What {@code depth}, {@code latch} and {@code qos} say. */
  private Qos delivery(boolean asOffered) {
    int most = depth.intValue();
    if (most < 0) {
      throw new RosException("depth: 0 or more messages expected, not " + most);
    }
    UValue keys = qos.val();
    if (keys.getType() != UDataType.DATA_DICTIONARY) {
      throw new RosException("qos: a Dictionary expected, as [\"reliability\" => \"best_effort\"]");
    }
    boolean kept = !asOffered && latch.booleanValue();
    Duration none = Qos.DEFAULT.deadline();
    return QosKeys.of(keys.udictionaryValue(), new Qos(true, kept, most, none, asOffered));
  }

  // ------------------------------------------------------------------ hearing

  /** Begins to listen. The job waits until the type is known. */
  public CompletionStage<Void> subscribe() {
    idle();
    Qos wanted = delivery(true);
    Node known = node();
    CompletableFuture<Void> typed = new CompletableFuture<>();
    return known
        .typeOf(topic)
        .thenCompose(name -> {
          try {
            type = known.definitions().message(name);
            typed.complete(null);
          } catch (DefinitionException e) {
            // A publisher tells what it means by that name.
            typed.orTimeout(PATIENCE, TimeUnit.SECONDS);
          }
          delivery.begin(wanted.depth());
          subscription = known.subscribe(topic, null, wanted, listener(typed));
          return typed.exceptionallyCompose(failure -> {
            unsubscribe();
            return CompletableFuture.failedFuture(
                new RosException(
                    "there is no definition of " + name + ", and no publisher has sent it",
                    failure));
          });
        });
  }

  /**
   * Begins to listen to messages of a type, whether there is somebody who publishes them already or
   * not. The job waits until the others can know.
   */
  public CompletionStage<Void> subscribeAs(String typeName) {
    idle();
    Qos wanted = delivery(true);
    Node there = node();
    MessageType known = there.definitions().message(typeName);
    delivery.begin(wanted.depth());
    type = known;
    subscription =
        there.subscribe(topic, known, wanted, listener(CompletableFuture.completedFuture(null)));
    return there.settled();
  }

  private Subscription.Listener listener(CompletableFuture<Void> typed) {
    return new Subscription.Listener() {
      @Override
      public void received(UDictionary message) {
        delivery.offer(message);
      }

      @Override
      public void typed(MessageType told) {
        type = told;
        typed.complete(null);
      }

      @Override
      public void failed(String reason) {
        troubled(reason);
      }
    };
  }

  private void troubled(String reason) {
    getUContext().report("ROS: " + topic + ": " + reason);
  }

  @Override
  public void take() {
    for (UDictionary next = delivery.next(); next != null; next = delivery.next()) {
      UValue message = new UValue(next);
      last.setValue(message);
      onMessage.emit(message);
    }
  }

  /** Ends listening. */
  public void unsubscribe() {
    Subscription present = subscription;
    if (present == null) {
      throw new RosException(topic + " is not subscribed");
    }
    subscription = null;
    delivery.end();
    present.close();
  }

  // ------------------------------------------------------------------ speaking

  /**
   * Offers messages of a type; of the one that others use if it is empty. The job waits until the
   * others can know.
   */
  public CompletionStage<Void> advertise(String typeName) {
    idle();
    return typeName.isEmpty() ? node().typeOf(topic).thenCompose(this::begin) : begin(typeName);
  }

  private CompletionStage<Void> begin(String typeName) {
    Node there = node();
    MessageType wanted = there.definitions().message(typeName);
    publisher =
        there.advertise(
            topic,
            wanted,
            delivery(false),
            new Publisher.Listener() {
              @Override
              public void connected(String name) {
                onConnect.emit(name);
              }

              @Override
              public void disconnected(String name) {
                onDisconnect.emit(name);
              }

              @Override
              public void failed(String reason) {
                troubled(reason);
              }
            });
    type = wanted;
    return there.settled();
  }

  /** Sends a message to all who listen. */
  public void publish(UDictionary message) {
    Publisher present = publisher;
    if (present == null) {
      throw new RosException(topic + " is not advertised");
    }
    present.publish(message);
  }

  /** Ends speaking. */
  public void unadvertise() {
    Publisher present = publisher;
    if (present == null) {
      throw new RosException(topic + " is not advertised");
    }
    publisher = null;
    present.close();
  }

  @Override
  public void close() {
    if (subscription != null) {
      unsubscribe();
    }
    if (publisher != null) {
      unadvertise();
    }
  }
}

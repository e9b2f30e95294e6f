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

  private static final CompletableFuture<Void> DONE = CompletableFuture.completedFuture(null);

  private final UEvent onMessage = new UEvent();
  private final UEvent onDeadline = new UEvent();
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

  /** That of the subscription. */
  private @Nullable Deadline deadline;

  private volatile @Nullable Publisher publisher;

  /** What a job waits for that subscribes or advertises; one of {@link #begin}. */
  private @Nullable CompletableFuture<Void> beginning;

  private boolean closed;

  public RosTopic(String name) {
    super(name);
    UBindEvent(onMessage, "onMessage");
    UBindEvent(onDeadline, "onDeadline");
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
          type = null;
        });
  }

  private Node node() {
    Node known = node;
    if (known == null) {
      throw new RosException("the topic has no name: init");
    }
    return known;
  }

  private synchronized void idle() {
    if (closed) {
      throw unwanted();
    }
    if (beginning != null) {
      throw new RosException(topic + " is being subscribed or advertised: that ends first");
    }
    if (subscription != null) {
      throw new RosException(topic + " is subscribed already: unsubscribe first");
    }
    if (publisher != null) {
      throw new RosException(topic + " is advertised already: unadvertise first");
    }
  }

  private RosException unwanted() {
    return new RosException(topic + " is not wanted any more");
  }

  private void checkWanted(CompletableFuture<Void> job) {
    if (job.isDone()) {
      throw unwanted();
    }
  }

  /** Work in the name of a job, which may be stopped meanwhile. */
  private interface Work {
    /**
     * Begins it.
     *
     * @param job is done, by failing, when nobody wants the work any more
     */
    CompletionStage<Void> begin(CompletableFuture<Void> job);
  }

  /**
   * Begins to hear or to speak; one at a time. What has come of it is closed if that fails, if the
   * job that waits is stopped, and if the topic ends.
   */
  private CompletionStage<Void> begin(Work work) {
    CompletableFuture<Void> job = new CompletableFuture<>();
    synchronized (this) {
      idle();
      beginning = job;
    }
    job.whenComplete((nothing, failure) -> {
      synchronized (this) {
        beginning = null;
      }
      if (failure != null) {
        silence();
      }
    });
    try {
      work.begin(job)
          .whenComplete((nothing, failure) -> {
            if (failure == null) {
              job.complete(null);
            } else {
              job.completeExceptionally(failure);
            }
          });
    } catch (RuntimeException e) {
      job.completeExceptionally(e);
      throw e;
    }
    return job;
  }

  /** The full name of the topic. */
  public String name() {
    return topic;
  }

  /** A new message of the type of the topic; void until that is subscribed or advertised. */
  public UValue structure() {
    MessageType known = type;
    return known == null ? new UValue() : new UValue(Templates.of(known));
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
    Qos wanted = delivery(true);
    Node known = node();
    return begin(job -> known.typeOf(topic).thenCompose(name -> hear(known, name, wanted, job)));
  }

  private CompletionStage<Void> hear(
      Node known, String typeName, Qos wanted, CompletableFuture<Void> job) {
    MessageType found;
    try {
      found = known.definitions().message(typeName);
    } catch (DefinitionException e) {
      return hearUndefined(known, typeName, wanted, job);
    }
    return known
        .prepared(found)
        .thenAccept(ready -> {
          type = found;
          hear(known, null, wanted, DONE, job);
        });
  }

  /** A publisher tells what it means by that name. */
  private CompletionStage<Void> hearUndefined(
      Node known, String typeName, Qos wanted, CompletableFuture<Void> job) {
    CompletableFuture<Void> typed = new CompletableFuture<>();
    typed.orTimeout(PATIENCE, TimeUnit.SECONDS);
    hear(known, null, wanted, typed, job);
    return typed.exceptionallyCompose(failure ->
        CompletableFuture.failedFuture(
            new RosException(
                "there is no definition of " + typeName + ", and no publisher has sent it",
                failure)));
  }

  private void hear(
      Node known,
      @Nullable MessageType wantedType,
      Qos wanted,
      CompletableFuture<Void> typed,
      CompletableFuture<Void> job) {
    checkWanted(job);
    delivery.begin(wanted.depth());
    Deadline limit = new Deadline(wanted.deadline(), onDeadline::emit);
    Subscription made = known.subscribe(topic, wantedType, wanted, listener(typed, limit));
    synchronized (this) {
      if (!job.isDone()) {
        subscription = made;
        deadline = limit;
        return;
      }
    }
    made.close();
    limit.end();
    throw unwanted();
  }

  /**
   * Begins to listen to messages of a type, whether there is somebody who publishes them already or
   * not. The job waits until the others can know.
   */
  public CompletionStage<Void> subscribeAs(String typeName) {
    Qos wanted = delivery(true);
    Node there = node();
    MessageType known = there.definitions().message(typeName);
    return begin(job ->
        there
            .prepared(known)
            .thenCompose(ready -> {
              hear(there, known, wanted, DONE, job);
              type = known;
              return there.settled();
            }));
  }

  private Subscription.Listener listener(CompletableFuture<Void> typed, Deadline limit) {
    return new Subscription.Listener() {
      @Override
      public void received(UDictionary message) {
        limit.heard();
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
    delivery.take(next -> {
      UValue message = new UValue(next);
      last.setValue(message);
      onMessage.emit(message);
    });
  }

  /** Ends listening. */
  public void unsubscribe() {
    if (!endHearing()) {
      throw new RosException(topic + " is not subscribed");
    }
  }

  private boolean endHearing() {
    Subscription present;
    Deadline limit;
    synchronized (this) {
      present = subscription;
      subscription = null;
      limit = deadline;
      deadline = null;
    }
    if (present == null || limit == null) {
      return false;
    }
    limit.end();
    delivery.end();
    present.close();
    return true;
  }

  // ------------------------------------------------------------------ speaking

  /**
   * Offers messages of a type; of the one that others use if it is empty. The job waits until the
   * others can know.
   */
  public CompletionStage<Void> advertise(String typeName) {
    Qos offered = delivery(false);
    Node there = node();
    return begin(job ->
        typeName.isEmpty()
            ? there.typeOf(topic).thenCompose(found -> speak(there, found, offered, job))
            : speak(there, typeName, offered, job));
  }

  private CompletionStage<Void> speak(
      Node there, String typeName, Qos offered, CompletableFuture<Void> job) {
    MessageType wanted = there.definitions().message(typeName);
    return there.prepared(wanted).thenCompose(ready -> speak(there, wanted, offered, job));
  }

  private CompletionStage<Void> speak(
      Node there, MessageType wanted, Qos offered, CompletableFuture<Void> job) {
    checkWanted(job);
    Publisher made = there.advertise(topic, wanted, offered, new Subscribers());
    synchronized (this) {
      if (!job.isDone()) {
        publisher = made;
        type = wanted;
        return there.settled();
      }
    }
    made.close();
    throw unwanted();
  }

  private final class Subscribers implements Publisher.Listener {
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
    if (!endSpeaking()) {
      throw new RosException(topic + " is not advertised");
    }
  }

  private boolean endSpeaking() {
    Publisher present;
    synchronized (this) {
      present = publisher;
      publisher = null;
    }
    if (present == null) {
      return false;
    }
    present.close();
    return true;
  }

  private void silence() {
    endHearing();
    endSpeaking();
  }

  /** Ends all of it, what has only begun, too. */
  @Override
  public void close() {
    CompletableFuture<Void> unfinished;
    synchronized (this) {
      closed = true;
      unfinished = beginning;
    }
    if (unfinished != null) {
      unfinished.completeExceptionally(unwanted());
    }
    silence();
  }
}

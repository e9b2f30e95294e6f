package org.urbi.ros.rcl;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.Actions;
import org.urbi.ros.graph.ClockFollower;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.ParameterServer;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.graph.ServiceServer;
import org.urbi.ros.graph.Severity;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.Definitions;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.TypeName;
import org.urbi.ros.rcl.Endpoints.Endpoint;
import org.urbi.ros.time.WallClock;
import org.urbi.ros.two.GraphSeekers;
import org.urbi.ros.two.Reports;
import org.urbi.ros.two.TwoConventions;
import org.urbi.ros.two.TwoHost;
import org.urbi.ros.two.TwoSettings;
import urbi.thread.GuardedThreads;

/** A node of an installed ROS 2. */
public final class RclNode implements TwoHost {
  private static final String RANGE = "ROS_AUTOMATIC_DISCOVERY_RANGE";

  /** Where libraries are loaded: threads of the system, since C needs the stack of one. */
  private static final Executor LOADING =
      task -> GuardedThreads.SDK.platform("urbi-ros-rcl-types", task).start();

  private final TwoSettings settings;
  private final Installation installation;
  private final Reports reports;
  private final GraphSeekers seekers = new GraphSeekers();
  private final Arrivals arrivals;
  private final Session session;
  private final NodeGraph graph;
  private final ClockFollower clock = new ClockFollower(this, WallClock::nanoseconds);
  private final TwoConventions conventions;
  private final Map<TypeName, MessageSupport> messages = new ConcurrentHashMap<>();
  private final Set<AutoCloseable> open = ConcurrentHashMap.newKeySet();
  private volatile boolean closed;

  /**
   * Closes it when the program ends before it does: else the middleware would wait in its own end
   * for its threads, which have been in Java code, and those for the virtual machine, for ever.
   */
  private final Thread atExit = GuardedThreads.SDK.platform("urbi-ros-exit", this::closeParts);

  private RclNode(TwoSettings settings, Installation installation, Consumer<String> people) {
    this.settings = settings;
    this.installation = installation;
    reports = new Reports(people);
    arrivals = new Arrivals(trouble -> reports.tell("what has come", trouble));
    try {
      session =
          new Session(installation.functions(), settings.domain(), name(), this::changed, reports);
    } catch (RuntimeException | Error e) {
      arrivals.close();
      throw e;
    }
    graph = new NodeGraph(session);
    try {
      conventions = new TwoConventions(this, clock, identity());
      session.begin();
    } catch (RuntimeException | Error e) {
      close();
      throw e;
    }
  }

  /** What no other node has, here or elsewhere. */
  private byte[] identity() {
    String text = name() + ProcessHandle.current().pid() + "@" + WallClock.nanoseconds();
    UUID hash = UUID.nameUUIDFromBytes(text.getBytes(StandardCharsets.UTF_8));
    return ByteBuffer.allocate(2 * Long.BYTES)
        .putLong(hash.getMostSignificantBits())
        .putLong(hash.getLeastSignificantBits())
        .array();
  }

  /**
   * Makes a node.
   *
   * @param people are told what goes wrong and was survived, by threads of the node
   * @throws RosException if the installation cannot be used; the text says why
   */
  static RclNode start(TwoSettings settings, Installation installation, Consumer<String> people) {
    installation.load();
    Libraries.environment(RANGE, settings.range());
    RclNode node = new RclNode(settings, installation, people);
    Runtime.getRuntime().addShutdownHook(node.atExit);
    return node;
  }

  private void changed() {
    seekers.changed(graph::snapshot);
  }

  Session session() {
    return session;
  }

  Arrivals arrivals() {
    return arrivals;
  }

  MessageSupport support(MessageType type) {
    // Nobody who has it waits for one that is being loaded.
    MessageSupport known = messages.get(type.name());
    return known != null ? known : loaded(type);
  }

  private MessageSupport loaded(MessageType type) {
    return messages.computeIfAbsent(type.name(), name -> MessageSupport.of(installation, type));
  }

  ServiceSupport support(ServiceType type) {
    MessageSupport request = support(type.request());
    MessageSupport response = support(type.response());
    return new ServiceSupport(
        MessageSupport.handle(installation.functions(), "service", type.name()), request, response);
  }

  /** Whether another node uses a topic of this one with another type, which is told then. */
  boolean isOfAnotherType(String topic, Endpoint other, String does, MessageType own) {
    if (other.type().equals(own.name().toString())) return false;
    reports.tell(
        "%s: %s %s %s, this node has %s"
            .formatted(topic, other.node(), does, other.type(), own.name()));
    return true;
  }

  /** Has something done at each change of the graph, by the thread of the graph. */
  Runnable seek(Runnable seeker) {
    return seekers.seek(seeker);
  }

  /** Something is there that is closed with the node. */
  void opened(AutoCloseable part) {
    open.add(part);
    // Who closes the node may have closed all that was there before.
    if (closed) close(part);
    else session.wake();
  }

  private void close(AutoCloseable part) {
    try {
      part.close();
    } catch (Exception e) {
      reports.tell("at the end", e);
    }
  }

  void closed(AutoCloseable part) {
    open.remove(part);
  }

  @Override
  public Reports reports() {
    return reports;
  }

  @Override
  public String name() {
    return settings.names().node();
  }

  @Override
  public Dialect version() {
    return Dialect.ROS_2;
  }

  @Override
  public CompletableFuture<Boolean> reachable() {
    return CompletableFuture.completedFuture(!closed);
  }

  @Override
  public Definitions definitions() {
    return settings.definitions();
  }

  @Override
  public CompletableFuture<Void> prepared(MessageType type) {
    return messages.containsKey(type.name())
        ? CompletableFuture.completedFuture(null)
        : CompletableFuture.runAsync(() -> loaded(type), LOADING);
  }

  @Override
  public String resolve(String name) {
    return settings.names().resolve(name);
  }

  @Override
  public CompletableFuture<Void> settled() {
    return CompletableFuture.completedFuture(null);
  }

  @Override
  public long now() {
    return clock.nanoseconds();
  }

  @Override
  public void log(Severity severity, String text) {
    conventions.log(severity, text);
  }

  @Override
  public ParameterServer parameters() {
    return conventions.parameters();
  }

  @Override
  public Actions actions() {
    return conventions.actions();
  }

  @Override
  public CompletableFuture<GraphSnapshot> graph() {
    return seekers.graph(graph::snapshot);
  }

  @Override
  public Runnable watch(Consumer<GraphSnapshot> listener) {
    return seekers.watch(listener);
  }

  @Override
  public CompletableFuture<String> typeOf(String topic) {
    String full = resolve(topic);
    return seekers.sought(
        () -> Optional.ofNullable(graph.topics().get(full)),
        "there is no topic " + full + ": Ros.topics has all");
  }

  @Override
  public CompletableFuture<String> typeOfService(String full, String missing) {
    return seekers.soughtToWait(() -> Optional.ofNullable(graph.services().get(full)), missing);
  }

  @Override
  public Publisher advertise(String topic, MessageType type, Qos qos, Publisher.Listener listener) {
    return new RclPublisher(this, resolve(topic), type, qos, listener);
  }

  @Override
  public Subscription subscribe(
      String topic, @Nullable MessageType type, Qos qos, Subscription.Listener listener) {
    return new RclSubscription(this, resolve(topic), type, qos, listener);
  }

  @Override
  public CompletableFuture<ServiceClient> client(
      String service, @Nullable ServiceType type, boolean keepAlive) {
    String full = resolve(service);
    if (type != null) return new RclServiceClient(this, full, type).ready();
    return typeOfService(full, "there is no service " + full + ": Ros.services has all")
        .thenCompose(
            found -> new RclServiceClient(this, full, definitions().service(found)).ready());
  }

  @Override
  public ServiceServer serve(String service, ServiceType type, ServiceServer.Handler handler) {
    String full = resolve(service);
    if (open.stream()
        .anyMatch(each -> each instanceof RclServiceServer known && known.service().equals(full)))
      throw new RosException(full + " is offered by this node already");
    return new RclServiceServer(this, full, type, handler);
  }

  @Override
  public void close() {
    try {
      Runtime.getRuntime().removeShutdownHook(atExit);
    } catch (IllegalStateException e) {
      // The program is ending: whoever comes first closes it.
    }
    closeParts();
  }

  private synchronized void closeParts() {
    if (closed) return;
    closed = true;
    List.copyOf(open).forEach(this::close);
    arrivals.close();
    session.close();
  }
}

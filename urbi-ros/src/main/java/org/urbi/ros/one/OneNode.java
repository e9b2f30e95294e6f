package org.urbi.ros.one;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.net.URI;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.Actions;
import org.urbi.ros.graph.ClockFollower;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.Node;
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
import org.urbi.ros.message.TypeHash;
import org.urbi.ros.time.WallClock;
import urbi.UDataType;
import urbi.thread.InternalFailure;

/** A node of ROS 1. The master may come later, go, and come back. */
public final class OneNode implements Node {
  /** How often a master that tells of publishers all the time is asked for them at once. */
  private static final int ASKED_AT_MOST = 10;

  private final OneSettings settings;
  private final XmlRpcClient client = new XmlRpcClient(Threads.POOL);
  private final Api master;
  private final XmlRpcServer slave;
  private final TcpRosServer server;
  private final MasterWatch watch;
  private final Parameters parameters;
  private final ClockFollower clock = new ClockFollower(this, WallClock::nanoseconds);
  private final Map<String, Publication> publications = new ConcurrentHashMap<>();
  private final List<OneSubscription> subscriptions = new CopyOnWriteArrayList<>();
  private final Map<String, OneServiceServer> services = new ConcurrentHashMap<>();
  private final Set<OneServiceClient> clients = ConcurrentHashMap.newKeySet();
  private final OneActions actions = new OneActions(this);
  private final List<Consumer<GraphSnapshot>> watchers = new CopyOnWriteArrayList<>();
  private final Consumer<Boolean> presence;

  /** How often a master has told who publishes; the list of subscriptions guards it. */
  private int updates;

  private @Nullable RosOut out;
  private volatile boolean closed;
  private @Nullable Boolean present;
  private @Nullable GraphSnapshot seen;

  private OneNode(OneSettings settings, Consumer<Boolean> presence) throws IOException {
    this.settings = settings;
    master = api(settings.master());
    slave = new XmlRpcServer(settings.bound(), new SlaveMethods(this));
    try {
      server = new TcpRosServer(settings.bound(), this);
    } catch (IOException e) {
      slave.close();
      throw e;
    }
    this.presence = presence;
    watch = new MasterWatch(master, this::looked);
    parameters = new Parameters(master, watch, this);
  }

  /**
   * Makes a node.
   *
   * @param presence told, by a thread of the node, whether there is a master, when that is known
   *     and whenever it changes
   * @throws RosException if this machine does not let us
   */
  public static OneNode start(OneSettings settings, Consumer<Boolean> presence) {
    try {
      OneNode node = new OneNode(settings, presence);
      node.server.start();
      node.out = new RosOut(node);
      node.parameters.watch(
          "/" + ClockFollower.PARAMETER,
          value ->
              node.clock.follow(value.getType() != UDataType.DATA_VOID && value.booleanValue()));
      return node;
    } catch (IOException e) {
      throw new RosException("no node of ROS: " + e.getMessage(), e);
    }
  }

  // ------------------------------------------------------------------ for the other classes

  Api api(URI uri) {
    return new Api(client, uri, settings.names().node());
  }

  @Override
  public Definitions definitions() {
    return settings.definitions();
  }

  String masterUri() {
    return settings.master().toString();
  }

  String host() {
    return settings.host();
  }

  int port() {
    return server.port();
  }

  @Override
  public String resolve(String name) {
    return settings.names().resolve(name);
  }

  /** Where masters and other nodes call this one. */
  String uri() {
    return "http://" + settings.host() + ":" + slave.port() + "/";
  }

  @Nullable Publication publication(String topic) {
    return publications.get(topic);
  }

  @Nullable OneServiceServer server(String service) {
    return services.get(service);
  }

  List<List<String>> published() {
    return publications.values().stream()
        .map(each -> List.of(each.topic(), each.typeName()))
        .toList();
  }

  List<String> publishedNames() {
    return publications.values().stream().map(Publication::topic).toList();
  }

  List<List<String>> subscribed() {
    return subscriptions.stream().map(each -> List.of(each.topic(), each.typeName())).toList();
  }

  void updatePublishers(String topic, List<URI> publishers) {
    synchronized (subscriptions) {
      updates++;
      for (OneSubscription each : subscriptions) {
        if (each.topic().equals(topic)) {
          each.update(publishers);
        }
      }
    }
  }

  private int updates() {
    synchronized (subscriptions) {
      return updates;
    }
  }

  /** Has the master tell who publishes on a topic, from now on. */
  private CompletableFuture<?> askForPublishers(Api told, String topic, String type, int tries) {
    int before = updates();
    return told.call(OneNode::addresses, "registerSubscriber", topic, type, uri())
        .thenCompose(publishers -> {
          synchronized (subscriptions) {
            if (updates == before || tries <= 1) {
              updatePublishers(topic, publishers);
              return CompletableFuture.completedFuture(null);
            }
          }
          // What it has told meanwhile may be newer than this answer, or older: it is asked again.
          return askForPublishers(told, topic, type, tries - 1);
        });
  }

  void updateParameter(String name, Object value) {
    parameters.update(name, value);
  }

  URI serviceAddress(String service) throws IOException {
    try {
      return lookUp(service).join();
    } catch (CompletionException e) {
      throw new IOException(requireNonNull(e.getCause()).getMessage(), e);
    }
  }

  private CompletableFuture<URI> lookUp(String service) {
    return master
        .call(value -> URI.create((String) value), "lookupService", service)
        .thenApply(address -> {
          if (address.getHost() == null || address.getPort() < 0) {
            throw new RosException("the master has no address of " + service);
          }
          return address;
        });
  }

  // ------------------------------------------------------------------ the node

  @Override
  public String name() {
    return settings.names().node();
  }

  @Override
  public Dialect version() {
    return Dialect.ROS_1;
  }

  @Override
  public long now() {
    return clock.nanoseconds();
  }

  @Override
  public Actions actions() {
    return actions;
  }

  @Override
  public Parameters parameters() {
    return parameters;
  }

  @Override
  public void log(Severity severity, String text) {
    requireNonNull(out, "every node that was started has one").log(severity, text);
  }

  @Override
  public CompletableFuture<Boolean> reachable() {
    return master.call(value -> true, "getPid").exceptionally(failure -> false);
  }

  @Override
  public CompletableFuture<GraphSnapshot> graph() {
    CompletableFuture<List<?>> types = master.call(value -> (List<?>) value, "getTopicTypes");
    CompletableFuture<List<?>> state = master.call(value -> (List<?>) value, "getSystemState");
    return state.thenCombine(
        types,
        (lists, pairs) -> {
          try {
            return SystemState.graph(lists, pairs);
          } catch (ClassCastException | IndexOutOfBoundsException e) {
            throw new RosException(masterUri() + " has no state that ROS knows", e);
          }
        });
  }

  @Override
  public CompletableFuture<String> typeOf(String topic) {
    String full = resolve(topic);
    return graph()
        .thenApply(graph -> {
          GraphSnapshot.TopicInfo info = graph.topics().get(full);
          if (info == null || info.type().equals("*") || info.type().isEmpty()) {
            throw new RosException("there is no topic " + full + ": Ros.topics has all");
          }
          return info.type();
        });
  }

  @Override
  public CompletableFuture<Void> settled() {
    return watch.settled();
  }

  /** After each look at the master, on the thread that looks. */
  private void looked(boolean there) {
    if (closed) {
      return;
    }
    try {
      if (present == null || present != there) {
        present = there;
        presence.accept(there);
      }
      if (there && !watchers.isEmpty()) {
        GraphSnapshot now = graph().join();
        if (!now.equals(seen)) {
          seen = now;
          watchers.forEach(each -> each.accept(now));
        }
      }
    } catch (CompletionException e) {
      // The master has just gone: the next look notices.
      seen = null;
    } catch (RuntimeException | Error e) {
      // A listener's failure: the node goes on.
      InternalFailure.log("a listener to the graph", e);
    }
  }

  @Override
  public Runnable watch(Consumer<GraphSnapshot> listener) {
    watchers.add(listener);
    return () -> watchers.remove(listener);
  }

  // ------------------------------------------------------------------ topics

  @Override
  public synchronized Publisher advertise(
      String topic, MessageType type, Qos qos, Publisher.Listener listener) {
    String full = resolve(topic);
    Publication known = publications.get(full);
    if (known != null) {
      return known.add(type, listener);
    }
    Publication made = new Publication(this, full, type, qos);
    Publisher publisher = made.add(type, listener);
    publications.put(full, made);
    watch.add(
        new Registration("publisher " + full) {
          @Override
          CompletableFuture<?> register(Api told) {
            return told.call(any -> any, "registerPublisher", full, made.typeName(), uri());
          }

          @Override
          CompletableFuture<?> unregister(Api told) {
            return told.call(any -> any, "unregisterPublisher", full, uri());
          }
        });
    return publisher;
  }

  synchronized void remove(Publication publication) {
    if (publications.remove(publication.topic(), publication)) {
      watch.remove("publisher " + publication.topic());
    }
  }

  @Override
  public synchronized Subscription subscribe(
      String topic, @Nullable MessageType type, Qos qos, Subscription.Listener listener) {
    String full = resolve(topic);
    OneSubscription subscription = new OneSubscription(this, full, type, listener);
    subscriptions.add(subscription);
    // The master tells who publishes to whoever registers: also to those who join later.
    watch.remove("subscriber " + full);
    watch.add(
        new Registration("subscriber " + full) {
          @Override
          CompletableFuture<?> register(Api told) {
            return askForPublishers(told, full, subscription.typeName(), ASKED_AT_MOST);
          }

          @Override
          CompletableFuture<?> unregister(Api told) {
            return told.call(any -> any, "unregisterSubscriber", full, uri());
          }
        });
    return subscription;
  }

  private static List<URI> addresses(Object list) {
    return ((List<?>) list).stream().map(each -> URI.create((String) each)).toList();
  }

  synchronized void remove(OneSubscription subscription) {
    boolean last =
        subscriptions.remove(subscription)
            && subscriptions.stream().noneMatch(each -> each.topic().equals(subscription.topic()));
    if (last) {
      watch.remove("subscriber " + subscription.topic());
    }
  }

  // ------------------------------------------------------------------ services

  @Override
  public CompletableFuture<ServiceClient> client(
      String service, @Nullable ServiceType type, boolean keepAlive) {
    String full = resolve(service);
    // The service may be one of our own, of which the master is yet to be told.
    return settled()
        .thenCompose(told -> lookUp(full))
        .exceptionallyCompose(failure -> CompletableFuture.failedFuture(unknown(full, failure)))
        .thenApplyAsync(
            address -> {
              ServiceType known = type != null ? type : typeOf(full, address);
              OneServiceClient made = new OneServiceClient(this, full, known, keepAlive);
              clients.add(made);
              return made;
            },
            Threads.POOL);
  }

  /** A master that refuses has no such service; one that is not there is another matter. */
  private static Throwable unknown(String service, Throwable failure) {
    Throwable cause = failure.getCause() == null ? failure : failure.getCause();
    return cause instanceof RosException && cause.getCause() == null
        ? new RosException("there is no service " + service + ": Ros.services has all")
        : cause;
  }

  private ServiceType typeOf(String service, URI address) {
    Map<String, String> header;
    try {
      header = OneServiceClient.probe(this, service, address);
    } catch (IOException e) {
      throw new RosException(service + " does not answer: " + e.getMessage(), e);
    }
    ServiceType type = definitions().service(header.getOrDefault(ConnectionHeader.TYPE, "?"));
    String md5 = header.get(ConnectionHeader.MD5);
    if (!TypeHash.md5(type).equals(md5)) {
      throw new RosException(
          service
              + " is of another version of "
              + type.name().in(Dialect.ROS_1)
              + " (MD5 sum "
              + md5
              + ") than the definition that was found");
    }
    return type;
  }

  void remove(OneServiceClient gone) {
    clients.remove(gone);
  }

  @Override
  public synchronized ServiceServer serve(
      String service, ServiceType type, ServiceServer.Handler handler) {
    String full = resolve(service);
    OneServiceServer made = new OneServiceServer(this, full, type, handler);
    if (services.putIfAbsent(full, made) != null) {
      throw new RosException(full + " is offered by this node already");
    }
    watch.add(
        new Registration("service " + full) {
          private String address() {
            return "rosrpc://" + settings.host() + ":" + server.port();
          }

          @Override
          CompletableFuture<?> register(Api told) {
            return told.call(any -> any, "registerService", full, address(), uri());
          }

          @Override
          CompletableFuture<?> unregister(Api told) {
            return told.call(any -> any, "unregisterService", full, address());
          }
        });
    return made;
  }

  synchronized void remove(OneServiceServer gone) {
    if (services.remove(gone.service(), gone)) {
      watch.remove("service " + gone.service());
    }
  }

  @Override
  public void close() {
    closed = true;
    actions.close();
    watch.close();
    publications.values().forEach(Publication::closeAll);
    subscriptions.forEach(OneSubscription::close);
    services.values().forEach(OneServiceServer::close);
    clients.forEach(OneServiceClient::close);
    try {
      slave.close();
      server.close();
    } catch (IOException e) {
      // They are closed, one way or another.
      return;
    } finally {
      client.close();
    }
  }
}

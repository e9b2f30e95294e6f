package org.urbi.ros.two;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.graph.ServiceServer;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.DefinitionException;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.rtps.EndpointInfo;
import org.urbi.ros.rtps.EndpointQos;
import org.urbi.ros.rtps.Guid;
import org.urbi.ros.rtps.Participant;
import org.urbi.ros.rtps.ParticipantInfo;
import org.urbi.ros.rtps.ParticipantListener;
import org.urbi.ros.rtps.ParticipantOptions;
import org.urbi.ros.rtps.Reader;
import org.urbi.ros.rtps.ReaderListener;
import org.urbi.ros.rtps.Sample;
import org.urbi.ros.rtps.Writer;
import org.urbi.ros.rtps.WriterListener;

/** A node of ROS 2, a participant of its own. Others may come and go. */
public final class TwoNode implements Node {
  private static final byte[] ENCLAVE = "enclave=/;".getBytes(StandardCharsets.UTF_8);
  private static final EndpointQos ENTITIES = EndpointQos.reliable(1).asTransientLocal();
  private static final EndpointQos ALL_ENTITIES =
      EndpointQos.reliable(EndpointQos.KEEP_ALL).asTransientLocal();
  private static final byte[] NO_DATA = {};

  private final TwoSettings settings;
  private final Participant participant;
  private final Writer entitiesWriter;
  private final Map<Guid, Entities> others = new ConcurrentHashMap<>();
  private final List<EndpointInfo> own = new CopyOnWriteArrayList<>();
  private final List<Consumer<GraphSnapshot>> watchers = new CopyOnWriteArrayList<>();
  private final List<Runnable> seekers = new CopyOnWriteArrayList<>();

  private TwoNode(TwoSettings settings) throws IOException {
    this.settings = settings;
    ParticipantOptions options =
        ParticipantOptions.loopback(settings.domain())
            .withAddress(settings.address())
            .withName(name())
            .withUserData(ENCLAVE);
    participant = Participant.open(options, new Changes());
    entitiesWriter =
        participant.writer(Entities.TOPIC, Entities.TYPE, ENTITIES, NO_DATA, WriterListener.NONE);
    participant.reader(
        Entities.TOPIC, Entities.TYPE, ALL_ENTITIES, NO_DATA, new EntitiesListener());
    tellEntities();
  }

  /**
   * Makes a node.
   *
   * @throws RosException if this machine does not let us
   */
  public static TwoNode start(TwoSettings settings) {
    try {
      return new TwoNode(settings);
    } catch (IOException | IllegalArgumentException e) {
      throw new RosException("no node of ROS 2: " + e.getMessage(), e);
    }
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
    return CompletableFuture.completedFuture(true);
  }

  TwoSettings settings() {
    return settings;
  }

  // ------------------------------------------------------------------ the graph

  private GraphSnapshot snapshot() {
    List<Entities> all = new ArrayList<>(others.values());
    all.add(ownEntities());
    List<EndpointInfo> endpoints = participant.endpoints();
    endpoints.addAll(own);
    return TwoGraph.snapshot(all, endpoints);
  }

  @Override
  public CompletableFuture<GraphSnapshot> graph() {
    return CompletableFuture.completedFuture(snapshot());
  }

  @Override
  public Runnable watch(Consumer<GraphSnapshot> listener) {
    watchers.add(listener);
    return () -> watchers.remove(listener);
  }

  private void changed() {
    seekers.forEach(Runnable::run);
    if (watchers.isEmpty()) return;
    GraphSnapshot now = snapshot();
    watchers.forEach(each -> each.accept(now));
  }

  /** Has something done at each change of the graph, by a thread of the network. */
  Runnable seek(Runnable seeker) {
    seekers.add(seeker);
    return () -> seekers.remove(seeker);
  }

  /** The writers and readers of others, and those of this node. */
  List<EndpointInfo> endpoints() {
    List<EndpointInfo> all = participant.endpoints();
    all.addAll(own);
    return all;
  }

  /** The node that has that writer or reader; its identifier if it has told of none. */
  String ownerOf(Guid endpoint) {
    for (Entities each : others.values())
      for (Entities.NodeEntities node : each.nodes())
        if (node.readers().contains(endpoint) || node.writers().contains(endpoint))
          return node.fullName();
    return own.stream().anyMatch(each -> each.guid().equals(endpoint))
        ? name()
        : endpoint.toString();
  }

  private Entities ownEntities() {
    int slash = name().lastIndexOf('/');
    String space = slash == 0 ? "/" : name().substring(0, slash);
    List<Guid> readers =
        own.stream().filter(each -> !each.isWriter()).map(EndpointInfo::guid).toList();
    List<Guid> writers =
        own.stream().filter(EndpointInfo::isWriter).map(EndpointInfo::guid).toList();
    Entities.NodeEntities node =
        new Entities.NodeEntities(space, name().substring(slash + 1), readers, writers);
    return new Entities(participant.guid(), List.of(node));
  }

  private synchronized void tellEntities() {
    entitiesWriter.write(ownEntities().encode());
  }

  // ------------------------------------------------------------------ writers and readers

  Writer writer(String topic, String type, EndpointQos qos, String hash, WriterListener events) {
    Writer writer = participant.writer(topic, type, qos, TwoGraph.userData(hash), events);
    own.add(writer.info());
    tellEntities();
    return writer;
  }

  Reader reader(String topic, String type, EndpointQos qos, String hash, ReaderListener events) {
    Reader reader = participant.reader(topic, type, qos, TwoGraph.userData(hash), events);
    own.add(reader.info());
    tellEntities();
    return reader;
  }

  void close(Writer writer) {
    writer.close();
    own.remove(writer.info());
    tellEntities();
  }

  void close(Reader reader) {
    reader.close();
    own.remove(reader.info());
    tellEntities();
  }

  static EndpointQos qos(Qos qos) {
    EndpointQos base =
        qos.reliable() ? EndpointQos.reliable(qos.depth()) : EndpointQos.bestEffort(qos.depth());
    EndpointQos kept = qos.keptForLate() ? base.asTransientLocal() : base;
    return qos.deadline().isZero() ? kept : kept.withDeadline(qos.deadline().toNanos());
  }

  @Override
  public Publisher advertise(String topic, MessageType type, Qos qos, Publisher.Listener listener) {
    return new TwoPublisher(this, settings.names().resolve(topic), type, qos, listener);
  }

  @Override
  public Subscription subscribe(
      String topic, @Nullable MessageType type, Qos qos, Subscription.Listener listener) {
    return new TwoSubscription(this, settings.names().resolve(topic), type, qos, listener);
  }

  @Override
  public CompletableFuture<ServiceClient> client(
      String service, @Nullable ServiceType type, boolean keepAlive) {
    String full = settings.names().resolve(service);
    if (type != null) return new TwoServiceClient(this, full, type).ready();
    String request = Mangling.request(full);
    for (EndpointInfo each : endpoints()) {
      if (each.isWriter() || !each.topic().equals(request)) continue;
      try {
        ServiceType known = settings.definitions().service(Mangling.serviceTypeOf(each.type()));
        return new TwoServiceClient(this, full, known).ready();
      } catch (DefinitionException e) {
        return CompletableFuture.failedFuture(e);
      }
    }
    return CompletableFuture.failedFuture(
        new RosException("there is no service " + full + ": no node offers it"));
  }

  @Override
  public ServiceServer serve(String service, ServiceType type, ServiceServer.Handler handler) {
    return new TwoServiceServer(this, settings.names().resolve(service), type, handler);
  }

  @Override
  public void close() {
    participant.close();
  }

  /** A failure that concerns nobody else: it is told as those of threads are. */
  static void told(Throwable failure) {
    Thread self = Thread.currentThread();
    self.getUncaughtExceptionHandler().uncaughtException(self, failure);
  }

  /**
   * Takes all that a reader has; what one sample leads to does not keep the next from being taken.
   */
  static void takeAll(Reader reader, Consumer<Sample> action) {
    for (Sample each = reader.take(); each != null; each = reader.take()) {
      try {
        if (!each.disposed()) action.accept(each);
      } catch (Throwable e) {
        told(e);
      }
    }
  }

  private final class Changes implements ParticipantListener {
    @Override
    public void trouble(String what, Throwable reason) {
      told(new RosException(what + ": " + reason.getMessage(), reason));
    }

    @Override
    public void found(EndpointInfo endpoint) {
      changed();
    }

    @Override
    public void lost(EndpointInfo endpoint) {
      changed();
    }

    @Override
    public void lost(ParticipantInfo gone) {
      others.keySet().removeIf(each -> each.prefix().equals(gone.prefix()));
      changed();
    }
  }

  private final class EntitiesListener implements ReaderListener {
    @Override
    public void available(Reader reader) {
      takeAll(reader, this::received);
    }

    private void received(Sample sample) {
      Guid writer = sample.identity().writer();
      if (writer.prefix().equals(participant.guid().prefix())) return;
      Entities entities = Entities.decode(sample.payload());
      // Nobody speaks for another participant.
      if (!entities.participant().prefix().equals(writer.prefix())) return;
      others.put(entities.participant(), entities);
      changed();
    }
  }
}

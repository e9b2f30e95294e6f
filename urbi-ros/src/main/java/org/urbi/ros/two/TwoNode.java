package org.urbi.ros.two;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
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
import org.urbi.ros.time.WallClock;

/** A node of ROS 2, a participant of its own. Others may come and go. */
public final class TwoNode implements TwoHost {
  private static final byte[] ENCLAVE = "enclave=/;".getBytes(StandardCharsets.UTF_8);
  private static final EndpointQos ENTITIES = EndpointQos.reliable(1).asTransientLocal();
  private static final EndpointQos ALL_ENTITIES =
      EndpointQos.reliable(EndpointQos.KEEP_ALL).asTransientLocal();
  private static final byte[] NO_DATA = {};

  /** Programs of the domain, and writers and readers of each, that are known at most. */
  private static final int MOST_OTHERS = 256;

  private static final int MOST_ENDPOINTS = 4096;

  /** So many samples are taken at once. */
  private static final int AT_ONCE = 64;

  private final TwoSettings settings;
  private final Reports reports;
  private final Owners owners = new Owners();
  private final Mismatches mismatches;
  private final Participant participant;
  private final Writer entitiesWriter;
  private final List<EndpointInfo> own = new CopyOnWriteArrayList<>();
  private final GraphSeekers seekers = new GraphSeekers();
  private final ClockFollower clock = new ClockFollower(this, WallClock::nanoseconds);
  private final TwoConventions conventions;
  private volatile boolean closed;

  private TwoNode(TwoSettings settings, Consumer<String> people) throws IOException {
    this.settings = settings;
    reports = new Reports(people);
    mismatches = new Mismatches(owners, reports);
    ParticipantOptions options =
        ParticipantOptions.loopback(settings.domain())
            .withAddress(settings.address())
            .withLimits(settings.isAlone() ? 0 : MOST_OTHERS, MOST_ENDPOINTS)
            .withName(name())
            .withUserData(ENCLAVE);
    participant = Participant.open(options, new Changes());
    try {
      entitiesWriter =
          participant.writer(Entities.TOPIC, Entities.TYPE, ENTITIES, NO_DATA, WriterListener.NONE);
      participant.reader(
          Entities.TOPIC, Entities.TYPE, ALL_ENTITIES, NO_DATA, new EntitiesListener());
      conventions = new TwoConventions(this, clock, participant.guid().bytes());
    } catch (RuntimeException | Error e) {
      participant.close();
      throw e;
    }
  }

  /**
   * Makes a node.
   *
   * @param people are told what goes wrong and was survived, by threads of the node
   * @throws RosException if this machine does not let us
   */
  public static TwoNode start(TwoSettings settings, Consumer<String> people) {
    try {
      return new TwoNode(settings, people);
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
    return CompletableFuture.completedFuture(!closed);
  }

  @Override
  public Definitions definitions() {
    return settings.definitions();
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
  public void log(Severity severity, String text) {
    conventions.log(severity, text);
  }

  @Override
  public ParameterServer parameters() {
    return conventions.parameters();
  }

  // ------------------------------------------------------------------ the graph

  private GraphSnapshot snapshot() {
    return TwoGraph.snapshot(owners.all(), endpoints());
  }

  @Override
  public CompletableFuture<GraphSnapshot> graph() {
    return seekers.graph(this::snapshot);
  }

  @Override
  public CompletableFuture<String> typeOf(String topic) {
    String full = resolve(topic);
    String wanted = Mangling.topic(full);
    return seekers.sought(
        () -> told(each -> each.topic().equals(wanted), each -> Mangling.typeOf(each.type())),
        "there is no topic " + full + ": Ros.topics has all");
  }

  /** What is told of a writer or reader, which a node that is new here need not have heard of. */
  private Optional<String> told(
      Predicate<EndpointInfo> wanted, Function<EndpointInfo, String> told) {
    return endpoints().stream().filter(wanted).findFirst().map(told);
  }

  @Override
  public Runnable watch(Consumer<GraphSnapshot> listener) {
    return seekers.watch(listener);
  }

  private void changed() {
    seekers.changed(this::snapshot);
  }

  private void tellWatchers() {
    seekers.tellWatchers(this::snapshot);
  }

  /** Has something done at each change of the graph, by a thread of the network. */
  Runnable seek(Runnable seeker) {
    return seekers.seek(seeker);
  }

  /** The writers and readers of others, and those of this node. */
  List<EndpointInfo> endpoints() {
    List<EndpointInfo> all = participant.endpoints();
    all.addAll(own);
    return all;
  }

  @Override
  public long now() {
    return clock.nanoseconds();
  }

  Owners owners() {
    return owners;
  }

  @Override
  public Reports reports() {
    return reports;
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
    Entities entities = ownEntities();
    owners.put(entities);
    entitiesWriter.write(entities.encode());
  }

  private void added(EndpointInfo endpoint) {
    endpoints().forEach(each -> mismatches.compare(endpoint, each));
    own.add(endpoint);
    tellEntities();
    tellWatchers();
  }

  // ------------------------------------------------------------------ writers and readers

  Writer writer(String topic, String type, EndpointQos qos, String hash, WriterListener events) {
    Writer writer = participant.writer(topic, type, qos, TwoGraph.userData(hash), events);
    added(writer.info());
    return writer;
  }

  Reader reader(String topic, String type, EndpointQos qos, String hash, ReaderListener events) {
    Reader reader = participant.reader(topic, type, qos, TwoGraph.userData(hash), events);
    added(reader.info());
    return reader;
  }

  void close(Writer writer) {
    writer.close();
    own.remove(writer.info());
    tellEntities();
    tellWatchers();
  }

  void close(Reader reader) {
    reader.close();
    own.remove(reader.info());
    tellEntities();
    tellWatchers();
  }

  static EndpointQos qos(Qos qos) {
    EndpointQos base =
        qos.reliable() ? EndpointQos.reliable(qos.depth()) : EndpointQos.bestEffort(qos.depth());
    EndpointQos kept = qos.keptForLate() ? base.asTransientLocal() : base;
    return qos.deadline().isZero() ? kept : kept.withDeadline(qos.deadline().toNanos());
  }

  @Override
  public Publisher advertise(String topic, MessageType type, Qos qos, Publisher.Listener listener) {
    return new TwoPublisher(this, resolve(topic), type, qos, listener);
  }

  @Override
  public Subscription subscribe(
      String topic, @Nullable MessageType type, Qos qos, Subscription.Listener listener) {
    return new TwoSubscription(this, resolve(topic), type, qos, listener);
  }

  @Override
  public CompletableFuture<ServiceClient> client(
      String service, @Nullable ServiceType type, boolean keepAlive) {
    String full = resolve(service);
    if (type != null) return new TwoServiceClient(this, full, type).ready();
    return typeOfService(full, "there is no service " + full + ": Ros.services has all")
        .thenCompose(
            found -> new TwoServiceClient(this, full, definitions().service(found)).ready());
  }

  @Override
  public CompletableFuture<String> typeOfService(String full, String missing) {
    String request = Mangling.request(full);
    return seekers.soughtToWait(
        () ->
            told(
                each -> !each.isWriter() && each.topic().equals(request),
                each -> Mangling.serviceTypeOf(each.type())),
        missing);
  }

  @Override
  public Actions actions() {
    return conventions.actions();
  }

  @Override
  public ServiceServer serve(String service, ServiceType type, ServiceServer.Handler handler) {
    String full = resolve(service);
    String request = Mangling.request(full);
    if (own.stream().anyMatch(each -> !each.isWriter() && each.topic().equals(request)))
      throw new RosException(full + " is offered by this node already");
    return new TwoServiceServer(this, full, type, handler);
  }

  @Override
  public void close() {
    closed = true;
    participant.close();
  }

  /**
   * Takes all that a reader has; what one sample leads to does not keep the next from being taken.
   */
  void takeAll(Reader reader, Consumer<Sample> action) {
    List<Sample> taken = reader.take(AT_ONCE);
    while (!taken.isEmpty()) {
      for (Sample each : taken) hand(each, reader, action);
      taken = reader.take(AT_ONCE);
    }
  }

  private void hand(Sample sample, Reader reader, Consumer<Sample> action) {
    try {
      if (!sample.disposed()) action.accept(sample);
    } catch (Throwable e) {
      reports.tell(reader.info().topic(), e);
    }
  }

  private final class Changes implements ParticipantListener {
    @Override
    public void trouble(String what, Throwable reason) {
      reports.tell(what, reason);
    }

    @Override
    public void found(EndpointInfo endpoint) {
      own.forEach(each -> mismatches.compare(each, endpoint));
      changed();
    }

    @Override
    public void lost(EndpointInfo endpoint) {
      changed();
    }

    @Override
    public void lost(ParticipantInfo gone) {
      owners.forget(gone.prefix());
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
      owners.put(entities);
      changed();
    }
  }
}

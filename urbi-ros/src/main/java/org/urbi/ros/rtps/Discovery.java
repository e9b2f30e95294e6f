package org.urbi.ros.rtps;

import static java.util.Objects.requireNonNull;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.time.SteadyClock;

/**
 * Finds other participants (SPDP), exchanges with them what writers and readers there are (SEDP),
 * and forgets them when they go or fall silent. The lock of the participant guards it.
 */
final class Discovery {
  private static final int AT_FIRST = 5;
  private static final long FIRST_PERIOD = TimeUnit.MILLISECONDS.toNanos(100);
  private static final long SHORTEST_LEASE = TimeUnit.MILLISECONDS.toNanos(100);

  /** Whoever comes first learns of all: the built-in topics keep what is, an instance for each. */
  private static final EndpointQos QOS = EndpointQos.reliable(1).asTransientLocal();

  private final Environment environment;
  private final UdpTransport transport;
  private final Matching matching;
  private final Routes routes;
  private final ParticipantListener listener;
  private final BiConsumer<String, Throwable> trouble;
  private final ParticipantInfo own;
  private final Map<GuidPrefix, RemoteParticipant> participants = new LinkedHashMap<>();
  private final Map<Integer, StatefulWriter> writers = new LinkedHashMap<>();
  private final Map<Integer, StatefulReader> readers = new LinkedHashMap<>();
  private final Reactor.Timer announcements;
  private final Reactor.Timer leases;
  private final Liveliness liveliness;
  private final long period;
  private int announced;

  Discovery(
      Environment environment,
      UdpTransport transport,
      ParticipantInfo own,
      Matching matching,
      Routes routes,
      ParticipantListener listener,
      BiConsumer<String, Throwable> trouble) {
    this.environment = environment;
    this.transport = transport;
    this.own = own;
    this.matching = matching;
    this.routes = routes;
    this.listener = listener;
    this.trouble = trouble;
    period = Math.min(TimeUnit.SECONDS.toNanos(3), own.lease() / 3);
    announcements = environment.reactor.timer("announcement", this::announce);
    leases = environment.reactor.timer("leases", this::checkLeases);
    writer(EntityId.PUBLICATIONS_WRITER);
    writer(EntityId.SUBSCRIPTIONS_WRITER);
    reader(EntityId.PUBLICATIONS_READER, new Descriptions(true));
    reader(EntityId.SUBSCRIPTIONS_READER, new Descriptions(false));
    liveliness = new Liveliness(environment, writer(EntityId.LIVELINESS_WRITER), matching, routes);
    reader(EntityId.LIVELINESS_READER, liveliness);
  }

  private StatefulWriter writer(int entity) {
    StatefulWriter writer = new StatefulWriter(environment, entity, QOS, () -> {});
    writers.put(entity, writer);
    return writer;
  }

  private void reader(int entity, SampleSink sink) {
    readers.put(entity, new StatefulReader(environment, entity, QOS, sink));
  }

  /** The built-in writer with that identifier. */
  @Nullable StatefulWriter writerOf(int entity) {
    return writers.get(entity);
  }

  Liveliness liveliness() {
    return liveliness;
  }

  List<ParticipantInfo> participants() {
    return participants.values().stream().map(RemoteParticipant::info).toList();
  }

  List<EndpointInfo> endpoints() {
    List<EndpointInfo> all = new ArrayList<>();
    participants.values().forEach(each -> all.addAll(each.endpoints.values()));
    return all;
  }

  // This participant, to others

  /** Says that it is there: to all at once, and to those of this machine that have no multicast. */
  void announce() {
    if (isAlone()) return;
    Set<InetSocketAddress> addresses = new LinkedHashSet<>();
    addresses.add(transport.multicastAddress());
    for (int i = 0; i < UdpTransport.PARTICIPANTS_LOOKED_FOR; i++)
      addresses.add(transport.neighbour(i));
    participants.values().forEach(each -> addresses.add(each.discovery));
    addresses.removeAll(own.discovery());
    describe(addresses.toArray(InetSocketAddress[]::new));
    announcements.in(announced++ < AT_FIRST ? FIRST_PERIOD : period);
  }

  /** Who is to know nobody is not to be known, either. */
  private boolean isAlone() {
    return environment.options.participants() == 0;
  }

  private void describe(InetSocketAddress... addresses) {
    send(new Change(1, 0, 0, DiscoveryCodec.encode(own), InlineQos.NONE), addresses);
  }

  private void send(Change change, InetSocketAddress... addresses) {
    environment
        .outbox
        .to(addresses, GuidPrefix.UNKNOWN, change.size() + MessageBuilder.OVERHEAD)
        .data(EntityId.PARTICIPANT_READER, EntityId.PARTICIPANT_WRITER, change);
  }

  /** Says that it goes. */
  void close() {
    if (!isAlone()) sayGoodbye();
    announcements.cancel();
    leases.cancel();
    writers.values().forEach(StatefulWriter::close);
    readers.values().forEach(StatefulReader::close);
  }

  private void sayGoodbye() {
    Guid guid = new Guid(own.prefix(), EntityId.PARTICIPANT);
    InlineQos gone = new InlineQos(true, guid, null);
    Change change = new Change(2, 0, 0, DiscoveryCodec.encodeKey(guid), gone);
    Set<InetSocketAddress> addresses = new LinkedHashSet<>(Set.of(transport.multicastAddress()));
    participants.values().forEach(each -> addresses.add(each.discovery));
    send(change, addresses.toArray(InetSocketAddress[]::new));
  }

  /** Tells everybody of a writer or reader of this participant. */
  void publish(EndpointInfo info) {
    writerFor(info).write(DiscoveryCodec.encode(info), new InlineQos(false, info.guid(), null));
  }

  /** Tells everybody that it is no more. */
  void withdraw(EndpointInfo info) {
    writerFor(info)
        .write(DiscoveryCodec.encodeKey(info.guid()), new InlineQos(true, info.guid(), null));
  }

  private StatefulWriter writerFor(EndpointInfo info) {
    int entity = info.isWriter() ? EntityId.PUBLICATIONS_WRITER : EntityId.SUBSCRIPTIONS_WRITER;
    return requireNonNull(writers.get(entity), "made by the constructor");
  }

  // Others

  /** Anything came from that participant. */
  void heard(GuidPrefix prefix) {
    RemoteParticipant participant = participants.get(prefix);
    if (participant != null) participant.heard();
  }

  /** A participant describes itself, or says that it goes. */
  void received(GuidPrefix sender, Submessage.Data data) throws MalformedException {
    if (data.qos().disposed()) {
      Guid key = data.qos().key();
      Guid gone = key != null ? key : DiscoveryCodec.decodeKey(data.payload());
      if (gone.prefix().equals(sender)) forget(sender);
      return;
    }
    ParticipantInfo info = DiscoveryCodec.decodeParticipant(data.payload());
    // Nobody speaks for somebody else, and one's own voice comes back by multicast.
    if (!info.prefix().equals(sender) || sender.equals(own.prefix()) || isAlone()) return;
    if (info.domain() >= 0 && info.domain() != own.domain()) return;
    InetSocketAddress address = reachable(info.discovery());
    if (address == null) return;
    RemoteParticipant known = participants.get(sender);
    if (known != null && !known.discovery.equals(address)) {
      // It was born again elsewhere, with the same name.
      forget(sender);
      known = null;
    }
    if (known == null) welcome(info, address);
    else update(known, info);
  }

  private void update(RemoteParticipant known, ParticipantInfo info) {
    boolean same =
        known.info().name().equals(info.name())
            && Arrays.equals(known.info().userData(), info.userData());
    known.update(atLeastShortestLease(info));
    if (!same) environment.reactor.later(() -> listener.found(info));
  }

  private static ParticipantInfo atLeastShortestLease(ParticipantInfo info) {
    return new ParticipantInfo(
        info.prefix(),
        info.domain(),
        info.name(),
        info.userData(),
        info.discovery(),
        info.user(),
        Math.max(SHORTEST_LEASE, info.lease()),
        info.builtin());
  }

  private void welcome(ParticipantInfo described, InetSocketAddress address) {
    if (participants.size() >= environment.options.participants()) {
      trouble.accept(
          "a participant is ignored: " + participants.size() + " others are known already",
          new IllegalStateException("too many participants"));
      return;
    }
    ParticipantInfo info = atLeastShortestLease(described);
    RemoteParticipant participant = new RemoteParticipant(info, address);
    participants.put(info.prefix(), participant);
    leases.atLatestIn(participant.left(SteadyClock.nanoseconds()));
    environment.reactor.later(() -> listener.found(info));
    describe(address);
    match(
        participant,
        ParticipantInfo.PUBLICATIONS_READER,
        EntityId.PUBLICATIONS_WRITER,
        EntityId.PUBLICATIONS_READER);
    match(
        participant,
        ParticipantInfo.SUBSCRIPTIONS_READER,
        EntityId.SUBSCRIPTIONS_WRITER,
        EntityId.SUBSCRIPTIONS_READER);
    match(
        participant,
        ParticipantInfo.LIVELINESS_READER,
        EntityId.LIVELINESS_WRITER,
        EntityId.LIVELINESS_READER);
    match(
        participant,
        ParticipantInfo.PUBLICATIONS_WRITER,
        EntityId.PUBLICATIONS_READER,
        EntityId.PUBLICATIONS_WRITER);
    match(
        participant,
        ParticipantInfo.SUBSCRIPTIONS_WRITER,
        EntityId.SUBSCRIPTIONS_READER,
        EntityId.SUBSCRIPTIONS_WRITER);
    match(
        participant,
        ParticipantInfo.LIVELINESS_WRITER,
        EntityId.LIVELINESS_READER,
        EntityId.LIVELINESS_WRITER);
  }

  /**
   * Matches one of the built-in endpoints with its counterpart, if the other participant has that.
   */
  private void match(RemoteParticipant participant, int bit, int ours, int theirs) {
    if (!participant.info().has(bit)) return;
    Guid guid = new Guid(participant.info().prefix(), theirs);
    StatefulWriter writer = writers.get(ours);
    if (writer != null) writer.match(guid, QOS, participant.discovery);
    StatefulReader reader = readers.get(ours);
    if (reader != null) {
      reader.match(guid, QOS, participant.discovery);
      routes.add(guid, reader);
    }
  }

  /** The first address that this participant may speak with; loopback ones come first. */
  private @Nullable InetSocketAddress reachable(List<InetSocketAddress> addresses) {
    InetSocketAddress found = null;
    for (InetSocketAddress each : addresses) {
      if (!transport.accepts(each.getAddress())) continue;
      if (each.getAddress().isLoopbackAddress()) return each;
      if (found == null) found = each;
    }
    return found;
  }

  private void checkLeases() {
    long now = SteadyClock.nanoseconds();
    List<GuidPrefix> dead = new ArrayList<>();
    long next = EndpointQos.INFINITE;
    for (RemoteParticipant each : participants.values()) {
      long left = each.left(now);
      if (left <= 0) dead.add(each.info().prefix());
      else next = Math.min(next, left);
    }
    dead.forEach(this::forget);
    if (next != EndpointQos.INFINITE) leases.in(next);
  }

  private void forget(GuidPrefix prefix) {
    RemoteParticipant participant = participants.remove(prefix);
    if (participant == null) return;
    for (EndpointInfo each : participant.endpoints.values()) gone(each);
    writers
        .values()
        .forEach(writer ->
            writer.matched().stream()
                .filter(each -> each.prefix().equals(prefix))
                .forEach(writer::unmatch));
    for (StatefulReader reader : readers.values()) {
      for (Guid each : reader.matched()) {
        if (!each.prefix().equals(prefix)) continue;
        reader.unmatch(each);
        routes.remove(each, reader);
      }
    }
    ParticipantInfo info = participant.info();
    environment.reactor.later(() -> listener.lost(info));
  }

  private void gone(EndpointInfo info) {
    matching.remove(info.guid());
    environment.reactor.later(() -> listener.lost(info));
  }

  /** Who receives the descriptions of others' writers, or of their readers. */
  private final class Descriptions implements SampleSink {
    private final boolean ofWriters;

    Descriptions(boolean ofWriters) {
      this.ofWriters = ofWriters;
    }

    @Override
    public boolean deliver(Sample sample) {
      RemoteParticipant participant = participants.get(sample.identity().writer().prefix());
      if (participant == null) return true;
      try {
        if (sample.disposed()) remove(participant, sample);
        else add(participant, DiscoveryCodec.decodeEndpoint(sample.payload(), ofWriters));
      } catch (MalformedException e) {
        trouble.accept("a description of a writer or reader cannot be understood", e);
      }
      return true;
    }

    private void add(RemoteParticipant participant, EndpointInfo info) throws MalformedException {
      if (!info.guid().prefix().equals(participant.info().prefix()))
        throw new MalformedException("description of another participant's endpoint");
      boolean isFull = participant.endpoints.size() >= environment.options.endpoints();
      if (isFull && !participant.endpoints.containsKey(info.guid()))
        throw new MalformedException("more endpoints than one participant may have");
      InetSocketAddress address =
          reachable(info.locators().isEmpty() ? participant.info().user() : info.locators());
      if (address == null) return;
      participant.endpoints.put(info.guid(), info);
      matching.add(info, address);
      environment.reactor.later(() -> listener.found(info));
    }

    private void remove(RemoteParticipant participant, Sample sample) throws MalformedException {
      Guid key = sample.key();
      EndpointInfo info =
          participant.endpoints.remove(
              key != null ? key : DiscoveryCodec.decodeKey(sample.payload()));
      if (info != null) gone(info);
    }

    @Override
    public void lost(Guid writer, long samples) {
      // What was replaced or withdrawn before it arrived.
    }

    @Override
    public void restarted(Guid writer) {
      // Not now: the reader is in the middle of it. Its next announcement brings it back.
      Reactor.Timer timer = environment.reactor.timer("forgetting", () -> forget(writer.prefix()));
      timer.in(0);
    }
  }
}

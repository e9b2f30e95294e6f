package org.urbi.ros.rtps;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.Condition;
import java.util.function.UnaryOperator;
import org.urbi.ros.time.WallClock;

/** One of those that exchange samples in a domain. Any thread may use it. */
public final class Participant implements AutoCloseable {
  private static final AtomicInteger OPENED = new AtomicInteger();
  private static final int LONGEST_USER_DATA = 32 << 10;

  private final ParticipantListener listener;
  private final UdpTransport transport;
  private final Reactor reactor;
  private final Environment environment;
  private final Matching matching;
  private final Discovery discovery;
  private final Routes routes = new Routes();
  private final Map<Integer, Writer> writers = new LinkedHashMap<>();
  private final Map<Integer, Reader> readers = new LinkedHashMap<>();
  private final ParticipantInfo info;
  private final Condition writerEnds;
  private int entities;
  private long malformed;
  private boolean closed;
  private boolean ended;

  /**
   * Opens its sockets, and begins to look for others.
   *
   * @throws IOException if there is no such address, or no port left
   */
  public static Participant open(ParticipantOptions options, ParticipantListener listener)
      throws IOException {
    return open(options, listener, newPrefix(), sink -> sink);
  }

  /** With a name of one's own, and something between it and the network. */
  static Participant open(
      ParticipantOptions options,
      ParticipantListener listener,
      GuidPrefix prefix,
      UnaryOperator<DatagramSink> network)
      throws IOException {
    if (options.userData().length > LONGEST_USER_DATA)
      throw new IllegalArgumentException("user data too long");
    UdpTransport transport =
        new UdpTransport(options.domain(), options.address(), listener::trouble);
    try {
      Participant participant = new Participant(options, listener, prefix, transport, network);
      participant.start();
      return participant;
    } catch (IOException | RuntimeException | Error e) {
      transport.close();
      throw e;
    }
  }

  private Participant(
      ParticipantOptions options,
      ParticipantListener listener,
      GuidPrefix prefix,
      UdpTransport transport,
      UnaryOperator<DatagramSink> network)
      throws IOException {
    this.listener = listener;
    this.transport = transport;
    reactor = new Reactor("urbi-ros-rtps-timers", this::trouble);
    writerEnds = reactor.newCondition();
    environment = new Environment(prefix, options, reactor, network.apply(transport));
    info =
        new ParticipantInfo(
            prefix,
            options.domain(),
            options.name(),
            options.userData(),
            List.of(transport.discoveryAddress()),
            List.of(transport.userAddress()),
            options.lease().toNanos(),
            ParticipantInfo.ALL);
    matching = new Matching(transport.userAddress());
    discovery =
        new Discovery(environment, transport, info, matching, routes, listener, this::trouble);
  }

  /** Nobody else's: of this vendor, process and moment. */
  private static GuidPrefix newPrefix() {
    long process = ProcessHandle.current().pid();
    long moment = WallClock.nanoseconds() / 1000 + OPENED.incrementAndGet();
    int beginning = MessageBuilder.VENDOR << 16 | (int) (moment >>> 32) & 0xffff;
    return new GuidPrefix(beginning, (int) process, (int) moment);
  }

  private void start() {
    Thread receiver = transport.receiving("urbi-ros-rtps-receiver", this::received);
    reactor.adopt(receiver);
    try {
      reactor.start();
      receiver.start();
      reactor.lock();
      try {
        discovery.announce();
      } finally {
        reactor.unlock();
      }
    } catch (RuntimeException | Error e) {
      // No thread is left, for one: the other must not stay alone.
      reactor.close();
      throw e;
    }
  }

  /** What others are told about it. */
  public ParticipantInfo info() {
    return info;
  }

  /** Its identifier. */
  public Guid guid() {
    return new Guid(info.prefix(), EntityId.PARTICIPANT);
  }

  /**
   * A new writer.
   *
   * @param userData for other applications to see
   * @throws IllegalStateException if the participant is closed
   */
  public Writer writer(
      String topic, String type, EndpointQos qos, byte[] userData, WriterListener events) {
    reactor.lock();
    try {
      EndpointInfo endpoint = endpoint(true, topic, type, qos, userData);
      Writer writer = new Writer(this, environment, endpoint, events);
      writers.put(endpoint.guid().entity(), writer);
      opened(writer.endpoint());
      discovery.liveliness().added(endpoint);
      return writer;
    } finally {
      reactor.unlock();
    }
  }

  /**
   * A new reader.
   *
   * @param userData for other applications to see
   * @throws IllegalStateException if the participant is closed
   */
  public Reader reader(
      String topic, String type, EndpointQos qos, byte[] userData, ReaderListener events) {
    reactor.lock();
    try {
      EndpointInfo endpoint = endpoint(false, topic, type, qos, userData);
      Reader reader = new Reader(this, environment, endpoint, events);
      readers.put(endpoint.guid().entity(), reader);
      opened(reader.endpoint());
      return reader;
    } finally {
      reactor.unlock();
    }
  }

  private EndpointInfo endpoint(
      boolean isWriter, String topic, String type, EndpointQos qos, byte[] userData) {
    if (closed) throw new IllegalStateException("the participant is closed");
    if (topic.isEmpty() || Math.max(topic.length(), type.length()) * 3 >= Wire.LONGEST_NAME)
      throw new IllegalArgumentException(
          "a name of " + topic.length() + " characters: take 1 to 340");
    if (userData.length > LONGEST_USER_DATA)
      throw new IllegalArgumentException("user data too long");
    int number = ++entities;
    Guid guid =
        new Guid(info.prefix(), isWriter ? EntityId.writer(number) : EntityId.reader(number));
    return new EndpointInfo(
        guid, isWriter, topic, type, qos, userData, List.of(), false, List.of());
  }

  private void opened(LocalEndpoint endpoint) {
    discovery.publish(endpoint.info());
    matching.add(endpoint);
  }

  /** A writer or reader of its own is closed, and others are told; with the lock. */
  void closed(LocalEndpoint endpoint) {
    int entity = endpoint.info().guid().entity();
    if (writers.remove(entity) != null) writerEnds.signalAll();
    readers.remove(entity);
    matching.remove(endpoint);
    discovery.withdraw(endpoint.info());
  }

  Routes routes() {
    return routes;
  }

  /** The other participants that are known. */
  public List<ParticipantInfo> participants() {
    reactor.lock();
    try {
      return discovery.participants();
    } finally {
      reactor.unlock();
    }
  }

  /** The writers and readers of all other participants. */
  public List<EndpointInfo> endpoints() {
    reactor.lock();
    try {
      return discovery.endpoints();
    } finally {
      reactor.unlock();
    }
  }

  /** How many datagrams came that were no RTPS, in whole or in part. */
  public long malformed() {
    reactor.lock();
    try {
      return malformed;
    } finally {
      reactor.unlock();
    }
  }

  /** Vouches for all writers whose liveliness is manual by participant. */
  public void assertLiveliness() {
    reactor.lock();
    try {
      discovery.liveliness().assertManual();
    } finally {
      reactor.unlock();
    }
  }

  /**
   * Closes what it has, and tells everybody that it goes. Waits until its reliable readers have
   * what was written, but no longer than the options allow.
   */
  @Override
  public void close() {
    reactor.lock();
    try {
      if (closed) return;
      closed = true;
      List.copyOf(writers.values()).forEach(Writer::close);
      List.copyOf(readers.values()).forEach(Reader::close);
      awaitWriters();
      ended = true;
      discovery.close();
      // Also if it is closed by what is called when something was received.
      reactor.leave();
    } finally {
      reactor.unlock();
    }
    reactor.close();
    transport.close();
  }

  /** What the participant's own threads close cannot wait for what these have to do. */
  private void awaitWriters() {
    long left = reactor.isCurrent() ? 0 : environment.options.linger().toNanos();
    try {
      while (!writers.isEmpty() && left > 0) {
        reactor.leave();
        left = writerEnds.awaitNanos(left);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    List.copyOf(writers.values()).forEach(Writer::end);
  }

  private void trouble(String what, Throwable reason) {
    listener.trouble(what, reason);
  }

  // What arrives

  private void received(ByteBuffer datagram, InetSocketAddress from) {
    reactor.lock();
    try {
      if (!ended) MessageParser.parse(datagram, this::received);
    } catch (MalformedException e) {
      malformed++;
    } finally {
      reactor.unlock();
      reactor.settle();
    }
  }

  private void received(MessageSource source, Submessage submessage) {
    GuidPrefix destination = source.destination();
    if (!destination.equals(GuidPrefix.UNKNOWN) && !destination.equals(info.prefix())) return;
    discovery.heard(source.sender());
    switch (submessage) {
      case Submessage.FromReader answer -> toWriter(source, answer);
      case Submessage.Data data when data.writer() == EntityId.PARTICIPANT_WRITER ->
          describe(source, data);
      case Submessage.FromWriter message -> toReaders(source, message);
    }
  }

  private void describe(MessageSource source, Submessage.Data data) {
    try {
      discovery.received(source.sender(), data);
    } catch (MalformedException e) {
      malformed++;
    }
  }

  private void toReaders(MessageSource source, Submessage.FromWriter message) {
    Guid writer = new Guid(source.sender(), message.writer());
    for (StatefulReader reader : routes.of(writer)) {
      if (message.reader() != EntityId.UNKNOWN && message.reader() != reader.entity()) continue;
      WriterProxy proxy = reader.of(writer);
      if (proxy == null) continue;
      switch (message) {
        case Submessage.Data data -> proxy.received(data, source.time());
        case Submessage.DataFragments fragments -> proxy.received(fragments, source.time());
        case Submessage.Heartbeat heartbeat -> proxy.received(heartbeat);
        case Submessage.FragmentHeartbeat heartbeat -> proxy.received(heartbeat);
        case Submessage.Gap gap -> proxy.received(gap);
      }
    }
  }

  private void toWriter(MessageSource source, Submessage.FromReader answer) {
    Guid reader = new Guid(source.sender(), answer.reader());
    Writer user = writers.get(answer.writer());
    StatefulWriter writer = user != null ? user.protocol() : discovery.writerOf(answer.writer());
    if (writer == null) return;
    switch (answer) {
      case Submessage.Acknowledgement acknowledgement -> writer.received(reader, acknowledgement);
      case Submessage.FragmentRequest request -> writer.received(reader, request);
    }
  }
}

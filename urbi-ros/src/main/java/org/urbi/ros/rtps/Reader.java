package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.time.SteadyClock;

/**
 * Receives samples of a topic, and keeps them until they are taken: the newest ones, or all; in the
 * latter case writers are told to wait when there are too many. Any thread may use it.
 */
public final class Reader implements AutoCloseable {
  private final Participant participant;
  private final Reactor reactor;
  private final EndpointInfo info;
  private final ReaderListener listener;
  private final Endpoint endpoint = new Endpoint();
  private final StatefulReader protocol;
  private final ArrayDeque<Sample> queue = new ArrayDeque<>();
  private final boolean keepsAll;
  private final int depth;
  private final long memory;
  private final Reactor.Timer livelinessTimer;
  private final Reactor.Timer deadlineTimer;
  private long lastSample;
  private long bytes;
  private long overwritten;
  private boolean refused;
  private boolean closed;

  Reader(
      Participant participant,
      Environment environment,
      EndpointInfo info,
      ReaderListener listener) {
    this.participant = participant;
    this.info = info;
    this.listener = listener;
    EndpointQos qos = info.qos();
    reactor = environment.reactor;
    keepsAll = qos.depth() == EndpointQos.KEEP_ALL;
    depth = keepsAll ? History.ALL : qos.depth();
    memory = environment.options.memory();
    protocol = new StatefulReader(environment, info.guid().entity(), qos, endpoint);
    livelinessTimer = reactor.timer("liveliness", this::checkLiveliness);
    deadlineTimer = reactor.timer("deadline", this::checkDeadline);
  }

  /** What others are told about it. */
  public EndpointInfo info() {
    return info;
  }

  /** Its identifier. */
  public Guid guid() {
    return info.guid();
  }

  LocalEndpoint endpoint() {
    return endpoint;
  }

  StatefulReader protocol() {
    return protocol;
  }

  /** The next sample, which is then no longer kept; null if there is none. */
  public @Nullable Sample take() {
    List<Sample> next = take(1);
    return next.isEmpty() ? null : next.getFirst();
  }

  /** The next samples, at most so many, which are then no longer kept. */
  public List<Sample> take(int most) {
    reactor.lock();
    try {
      List<Sample> taken = new ArrayList<>(Math.min(most, queue.size()));
      while (taken.size() < most && !queue.isEmpty()) {
        Sample sample = queue.remove();
        bytes -= sample.payload().remaining();
        taken.add(sample);
      }
      // Not for each one: whoever keeps all asks for a lot at once.
      if (refused && queue.size() <= depth / 2 && bytes <= memory / 2) {
        refused = false;
        protocol.resume();
      }
      return taken;
    } finally {
      reactor.unlock();
    }
  }

  /** How many samples were overwritten by newer ones before they were taken. */
  public long overwritten() {
    reactor.lock();
    try {
      return overwritten;
    } finally {
      reactor.unlock();
    }
  }

  /** The writers that send it samples. */
  public List<Guid> matched() {
    reactor.lock();
    try {
      return protocol.matched();
    } finally {
      reactor.unlock();
    }
  }

  /** Tells everybody that it is no more; what it has is dropped. */
  @Override
  public void close() {
    reactor.lock();
    try {
      if (closed) return;
      closed = true;
      participant.routes().remove(protocol);
      protocol.close();
      livelinessTimer.cancel();
      deadlineTimer.cancel();
      queue.clear();
      participant.closed(endpoint);
    } finally {
      reactor.unlock();
    }
  }

  private void checkLiveliness() {
    long now = SteadyClock.nanoseconds();
    boolean[] some = {false};
    protocol.forEach(proxy -> {
      some[0] = true;
      if (!proxy.aliveChanges(now)) return;
      boolean alive = proxy.isAlive();
      reactor.later(() -> listener.liveliness(this, proxy.writer(), alive));
    });
    if (some[0]) livelinessTimer.in(Math.max(1, info.qos().lease() / 2));
  }

  private void checkDeadline() {
    if (protocol.matched().isEmpty()) return;
    long deadline = info.qos().deadline();
    long left = lastSample + deadline - SteadyClock.nanoseconds();
    if (left <= 0) {
      lastSample = SteadyClock.nanoseconds();
      reactor.later(() -> listener.deadlineMissed(this));
    }
    deadlineTimer.in(left <= 0 ? deadline : left);
  }

  /** As seen by what brings writers and readers together, and by the protocol. */
  private final class Endpoint implements LocalEndpoint, SampleSink {
    @Override
    public EndpointInfo info() {
      return info;
    }

    @Override
    public boolean deliver(Sample sample) {
      int size = sample.payload().remaining();
      while (!queue.isEmpty() && (queue.size() >= depth || bytes + size > memory)) {
        if (keepsAll && info.qos().reliable()) {
          refused = true;
          return false;
        }
        bytes -= queue.remove().payload().remaining();
        overwritten++;
      }
      lastSample = SteadyClock.nanoseconds();
      queue.add(sample);
      bytes += size;
      if (queue.size() == 1) reactor.later(() -> listener.available(Reader.this));
      return true;
    }

    @Override
    public void lost(Guid writer, long samples) {
      reactor.later(() -> listener.lost(Reader.this, writer, samples));
    }

    @Override
    public void match(EndpointInfo writer, InetSocketAddress address) {
      protocol.match(writer.guid(), writer.qos(), address);
      participant.routes().add(writer.guid(), protocol);
      EndpointQos qos = info.qos();
      if (qos.lease() != EndpointQos.INFINITE) livelinessTimer.atLatestIn(qos.lease());
      if (qos.deadline() != EndpointQos.INFINITE && !deadlineTimer.isSet()) {
        lastSample = SteadyClock.nanoseconds();
        deadlineTimer.in(qos.deadline());
      }
      reactor.later(() -> listener.matched(Reader.this, writer));
    }

    @Override
    public void unmatch(Guid writer) {
      if (!isMatched(writer)) return;
      protocol.unmatch(writer);
      participant.routes().remove(writer, protocol);
      reactor.later(() -> listener.unmatched(Reader.this, writer));
    }

    @Override
    public boolean isMatched(Guid writer) {
      return protocol.of(writer) != null;
    }

    @Override
    public void hindered(EndpointInfo writer, String policy) {
      reactor.later(() -> listener.hindered(Reader.this, writer, policy));
    }
  }
}

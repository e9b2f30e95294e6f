package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.locks.Condition;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;

/** Writes samples of a topic. Any thread may use it. */
public final class Writer implements AutoCloseable {
  private final Participant participant;
  private final Reactor reactor;
  private final EndpointInfo info;
  private final WriterListener listener;
  private final LocalEndpoint endpoint = new Endpoint();
  private final StatefulWriter protocol;
  private final Condition roomCondition;
  private final Reactor.Timer lingering;
  private final int largest;
  private final long linger;
  private boolean hadNoRoom;
  private boolean closed;
  private boolean ended;

  Writer(
      Participant participant,
      Environment environment,
      EndpointInfo info,
      WriterListener listener) {
    this.participant = participant;
    this.info = info;
    this.listener = listener;
    reactor = environment.reactor;
    largest = environment.options.largestSample();
    linger = environment.options.linger().toNanos();
    protocol = new StatefulWriter(environment, info.guid().entity(), info.qos(), this::roomChanges);
    roomCondition = reactor.newCondition();
    lingering = reactor.timer("end of a writer", this::end);
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

  StatefulWriter protocol() {
    return protocol;
  }

  /**
   * Writes a sample. Never waits: with a history that keeps the newest, the oldest sample is
   * overwritten, delivered or not; one that keeps all may have no room.
   *
   * @param payload with its encapsulation header; belongs to the writer from now on
   * @return its number, from 1; 0 if there was no room, or the writer is closed
   * @throws IllegalArgumentException if it is longer than samples may be
   */
  public long write(ByteBuffer payload) {
    return write(payload, null);
  }

  /** Writes a sample that says which other it answers. */
  public long write(ByteBuffer payload, @Nullable SampleIdentity related) {
    if (payload.remaining() > largest)
      throw new IllegalArgumentException(
          "sample of " + payload.remaining() + " bytes, at most are allowed " + largest);
    reactor.lock();
    try {
      if (closed) return 0;
      InlineQos inline = related == null ? InlineQos.NONE : new InlineQos(false, null, related);
      long number = protocol.write(payload, inline);
      hadNoRoom |= number == 0;
      return number;
    } finally {
      reactor.unlock();
    }
  }

  /** Whether another sample would find room, and overwrite none that is still to be delivered. */
  public boolean hasRoom() {
    reactor.lock();
    try {
      boolean room = protocol.hasRoom(1);
      hadNoRoom |= !room;
      return room;
    } finally {
      reactor.unlock();
    }
  }

  /**
   * Waits at most so many nanoseconds until there is room.
   *
   * @return whether there is
   */
  public boolean awaitRoom(long nanos) throws InterruptedException {
    return await(nanos, () -> protocol.hasRoom(1));
  }

  /**
   * Waits at most so many nanoseconds until all reliable readers have everything that was written.
   *
   * @return whether they have
   */
  public boolean awaitAcknowledged(long nanos) throws InterruptedException {
    return await(nanos, protocol::isAcknowledged);
  }

  private boolean await(long nanos, BooleanSupplier condition) throws InterruptedException {
    reactor.lock();
    try {
      long left = nanos;
      while (!closed && !condition.getAsBoolean()) {
        if (left <= 0) return false;
        reactor.leave();
        left = roomCondition.awaitNanos(left);
      }
      return !closed;
    } finally {
      reactor.unlock();
    }
  }

  private void roomChanges() {
    roomCondition.signalAll();
    // Not at once: whoever has noticed it still looks at the readers.
    if (closed && !ended && protocol.isAcknowledged()) lingering.in(0);
    if (!hadNoRoom || !protocol.hasRoom(1)) return;
    hadNoRoom = false;
    reactor.later(() -> listener.room(this));
  }

  /** The readers that get its samples. */
  public List<Guid> matched() {
    reactor.lock();
    try {
      return protocol.matched();
    } finally {
      reactor.unlock();
    }
  }

  /** Shows that it is alive, where its liveliness is by topic. */
  public void assertLiveliness() {
    reactor.lock();
    try {
      protocol.assertLiveliness();
    } finally {
      reactor.unlock();
    }
  }

  /**
   * Takes no more samples, and tells everybody that it is no more: at once if all reliable readers
   * have what was written, else when they have it, or after the time for that. Never waits.
   */
  @Override
  public void close() {
    reactor.lock();
    try {
      if (closed) return;
      closed = true;
      roomCondition.signalAll();
      if (protocol.isAcknowledged()) end();
      else lingering.in(linger);
    } finally {
      reactor.unlock();
    }
  }

  /** Serves nobody any more; with the lock. */
  void end() {
    if (ended) return;
    ended = true;
    lingering.cancel();
    protocol.close();
    participant.closed(endpoint);
  }

  /** As seen by what brings writers and readers together. */
  private final class Endpoint implements LocalEndpoint {
    @Override
    public EndpointInfo info() {
      return info;
    }

    @Override
    public void match(EndpointInfo reader, InetSocketAddress address) {
      if (closed) return;
      protocol.match(reader.guid(), reader.qos(), address);
      reactor.later(() -> listener.matched(Writer.this, reader));
    }

    @Override
    public void unmatch(Guid reader) {
      if (!protocol.serves(reader)) return;
      protocol.unmatch(reader);
      if (!closed) reactor.later(() -> listener.unmatched(Writer.this, reader));
    }

    @Override
    public boolean isMatched(Guid reader) {
      return protocol.serves(reader);
    }

    @Override
    public void hindered(EndpointInfo reader, String policy) {
      if (!closed) reactor.later(() -> listener.hindered(Writer.this, reader, policy));
    }
  }
}

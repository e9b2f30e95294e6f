package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.urbi.ros.time.SteadyClock;
import org.urbi.ros.time.WallClock;

/**
 * The protocol of a writer: keeps samples, sends them to the readers it knows, and again to those
 * that miss some. The lock of the participant guards it.
 */
final class StatefulWriter {
  private static final long FIRST_HEARTBEAT = TimeUnit.MILLISECONDS.toNanos(10);
  private static final long SLOWEST_HEARTBEAT = TimeUnit.SECONDS.toNanos(1);

  /** Who answers nothing for so long is not waited for. */
  private static final long LAG = TimeUnit.MILLISECONDS.toNanos(250);

  /** So many bytes are sent again at once; the rest is asked for by the next answer. */
  private static final int AGAIN_AT_ONCE = 96 << 10;

  private final Environment environment;
  private final int entity;
  private final EndpointQos qos;
  private final History history;
  private final Runnable room;
  private final Map<Guid, ReaderProxy> readers = new LinkedHashMap<>();
  private final Map<Guid, Long> newest = new HashMap<>();
  private final TreeMap<Long, Guid> disposals = new TreeMap<>();
  private final Window window = new Window();
  private final Pacing pacing = new Pacing();
  private final Reactor.Timer heartbeats;
  private final Reactor.Timer paced;
  private InetSocketAddress[] addresses = {};

  /** The participant of all readers, if they are all of the same. */
  private GuidPrefix destination = GuidPrefix.UNKNOWN;

  private boolean hasReliableReaders;
  private long heartbeatPeriod = FIRST_HEARTBEAT;
  private int heartbeatCount;
  private int unasked;

  /** How many samples may be on their way. */
  private int allowed = 1;

  /** All up to this one were sent when the readers were last told what there is. */
  private long announced;

  /** All up to this one have been sent. */
  private long sent;

  /**
   * Of the next one, so many fragments have been sent already, if it still is the one they are of.
   */
  private int sentFragments;

  private long fragmentsOf;

  /** {@code room} is called, with the lock, when samples have been acknowledged. */
  StatefulWriter(Environment environment, int entity, EndpointQos qos, Runnable room) {
    this.environment = environment;
    this.entity = entity;
    this.qos = qos;
    this.room = room;
    history = new History(qos.depth(), environment.options.memory());
    heartbeats = environment.reactor.timer("heartbeat", this::heartbeatIsDue);
    paced = environment.reactor.timer("sending of fragments", this::pump);
  }

  Guid guid() {
    return new Guid(environment.prefix, entity);
  }

  EndpointQos qos() {
    return qos;
  }

  /**
   * Whether a sample of that size can be written without overwriting one that somebody still waits
   * for.
   */
  boolean hasRoom(int size) {
    return !history.isFullFor(size)
        && history.last() - Math.min(sent, leastAcknowledged(false)) < history.depth();
  }

  /** Whether all has arrived that was written. */
  boolean isAcknowledged() {
    return sent == history.last() && leastAcknowledged(true) >= sent;
  }

  /** The number that the sample got, 0 if there is no room for it. */
  long write(ByteBuffer payload, InlineQos inline) {
    Guid key = inline.key();
    if (qos.lifespan() != EndpointQos.INFINITE)
      history.removeWrittenBefore(SteadyClock.nanoseconds() - qos.lifespan());
    if (readers.isEmpty() && !qos.transientLocal()) {
      history.skip();
      sent = history.last();
      return sent;
    }
    if (history.isFullFor(payload.remaining())) return 0;
    if (key != null) {
      Long before = newest.get(key);
      if (before != null) history.remove(before);
    }
    while (key == null && history.overflowsWith(payload.remaining())) {
      // What waits only for the window is not lost for its sake; what waits for its turn in
      // fragments is.
      if (history.first() > sent) sendBeforeItGoes();
      history.removeOldest();
    }
    long time = WallClock.nanoseconds();
    Change change =
        new Change(history.nextNumber(), time, SteadyClock.nanoseconds(), payload, inline);
    history.add(change);
    if (key != null) newest.put(key, change.sequence());
    if (key != null && inline.disposed()) disposals.put(change.sequence(), key);
    heartbeatPeriod = FIRST_HEARTBEAT;
    pump();
    return change.sequence();
  }

  private void sendBeforeItGoes() {
    Change change = history.from(sent + 1);
    if (change == null || isFragmented(change)) return;
    sendWhole(change);
  }

  /** Begins to serve a reader. */
  void match(Guid guid, EndpointQos requested, InetSocketAddress address) {
    boolean all = qos.transientLocal() && requested.transientLocal();
    boolean reliable = qos.reliable() && requested.reliable();
    ReaderProxy reader =
        new ReaderProxy(guid, reliable, address, all, all ? history.first() : sent + 1);
    readers.put(guid, reader);
    readersChanged();
    if (reliable) {
      introduce(reader);
      heartbeatPeriod = FIRST_HEARTBEAT;
      heartbeats.atLatestIn(heartbeatPeriod);
    } else if (all) {
      for (Change each = history.from(1);
          each != null && each.sequence() <= sent;
          each = history.from(each.sequence() + 1)) sendAgain(reader, each);
      pump();
    }
  }

  void unmatch(Guid guid) {
    if (readers.remove(guid) == null) return;
    readersChanged();
    acknowledgedMore();
    pump();
  }

  private void readersChanged() {
    addresses =
        readers.values().stream()
            .map(reader -> reader.address)
            .distinct()
            .toArray(InetSocketAddress[]::new);
    hasReliableReaders = readers.values().stream().anyMatch(reader -> reader.reliable);
    List<GuidPrefix> participants =
        readers.keySet().stream().map(Guid::prefix).distinct().limit(2).toList();
    destination = participants.size() == 1 ? participants.getFirst() : GuidPrefix.UNKNOWN;
  }

  boolean serves(Guid reader) {
    return readers.containsKey(reader);
  }

  List<Guid> matched() {
    return List.copyOf(readers.keySet());
  }

  void close() {
    heartbeats.cancel();
    paced.cancel();
    readers.clear();
  }

  /** Tells the readers that the writer lives. */
  void assertLiveliness() {
    for (ReaderProxy each : readers.values()) {
      heartbeat(to(each), each.guid.entity(), true, true);
    }
  }

  // What is sent

  private boolean isFragmented(Change change) {
    return change.size() > environment.options.fragmentSize();
  }

  /**
   * Sends what may be sent now. An acknowledgement or a timer goes on later, if something is left.
   */
  private void pump() {
    if (!pumpRequested()) return;
    while (sent < history.last()) {
      Change change = history.from(sent + 1);
      if (change == null || addresses.length == 0) {
        sent = history.last();
        break;
      }
      sent = change.sequence() - 1;
      if (!isFragmented(change)) {
        if (isWindowFull(change)) break;
        sendWhole(change);
      } else if (!sendFragments(change)) {
        break;
      }
    }
    discardAcknowledged();
  }

  /** Whether all fragments that were asked for again have been sent. */
  private boolean pumpRequested() {
    for (ReaderProxy reader : readers.values()) {
      while (!reader.requested.isEmpty()) {
        Map.Entry<Long, BitSet> entry = reader.requested.firstEntry();
        Change change = history.get(entry.getKey());
        int index = entry.getValue().nextSetBit(0);
        if (change == null || index < 0) {
          reader.requested.pollFirstEntry();
          if (reader.reliable) tell(reader);
          continue;
        }
        long now = SteadyClock.nanoseconds();
        if (waits(now)) return false;
        entry.getValue().clear(index);
        int size = environment.options.fragmentSize();
        environment
            .outbox
            .to(reader.address, reader.guid.prefix(), size + MessageBuilder.OVERHEAD)
            .fragment(reader.guid.entity(), entity, change, index, size);
        pacing.sent(size, now);
      }
    }
    return true;
  }

  private boolean waits(long now) {
    long wait = pacing.pause(now);
    if (wait > 0) paced.in(wait);
    return wait > 0;
  }

  private void sendWhole(Change change) {
    environment
        .outbox
        .sample(this, addresses, destination, change.size() + MessageBuilder.OVERHEAD)
        .data(EntityId.UNKNOWN, entity, change);
    sent = change.sequence();
    allowed = window.samples(change.size());
  }

  /** A datagram with samples of this writer is complete: says which ones it has. */
  void announce(MessageBuilder message) {
    if (!hasReliableReaders) return;
    long acknowledged = leastAcknowledged(false);
    unasked += (int) (sent - announced);
    // Asked for at first, so that a single sample needs no timer, and often enough that the
    // window never closes.
    boolean ask =
        announced <= acknowledged
            || unasked >= Math.max(1, allowed / 4)
            || sent - acknowledged >= allowed;
    announced = sent;
    if (ask) unasked = 0;
    heartbeat(message, EntityId.UNKNOWN, !ask, false);
    heartbeats.atLatestIn(heartbeatPeriod);
  }

  /** Whether the last fragment has been sent. */
  private boolean sendFragments(Change change) {
    if (fragmentsOf != change.sequence()) {
      if (isWindowFull(change)) return false;
      fragmentsOf = change.sequence();
      sentFragments = 0;
    }
    int size = environment.options.fragmentSize();
    int all = change.fragments(size);
    while (sentFragments < all) {
      long now = SteadyClock.nanoseconds();
      if (waits(now)) return false;
      MessageBuilder message =
          environment.outbox.to(addresses, destination, size + MessageBuilder.OVERHEAD);
      message.fragment(EntityId.UNKNOWN, entity, change, sentFragments++, size);
      if (sentFragments == all) {
        sent = change.sequence();
        if (hasReliableReaders) {
          heartbeat(message, EntityId.UNKNOWN, false, false);
          heartbeats.atLatestIn(heartbeatPeriod);
        }
      }
      pacing.sent(size, now);
    }
    return true;
  }

  private boolean isWindowFull(Change change) {
    if (!hasReliableReaders) return false;
    return sent - leastAcknowledged(false) >= window.samples(change.size());
  }

  /**
   * The number up to which all reliable readers have acknowledged what was sent; of the last sample
   * sent if there is no such reader.
   *
   * @param withLagging whether readers that lag behind count, too
   */
  private long leastAcknowledged(boolean withLagging) {
    long least = sent;
    for (ReaderProxy each : readers.values())
      if (each.reliable && (withLagging || !each.lags)) least = Math.min(least, each.acknowledged);
    return least;
  }

  /** Where to put a heartbeat, or a gap and two of them, for one reader. */
  private MessageBuilder to(ReaderProxy reader) {
    int bytes = MessageBuilder.SET_SIZE + 2 * MessageBuilder.HEARTBEAT_SIZE;
    return environment.outbox.to(reader.address, reader.guid.prefix(), bytes);
  }

  private void heartbeat(
      MessageBuilder message, int reader, boolean answerIsOptional, boolean liveliness) {
    long first = Math.min(history.first(), sent + 1);
    message.heartbeat(reader, entity, first, sent, ++heartbeatCount, answerIsOptional, liveliness);
  }

  /** Asks one reader what it has. */
  private void tell(ReaderProxy reader) {
    heartbeat(to(reader), reader.guid.entity(), false, false);
  }

  /** Tells one reader where it begins, and asks what it has. */
  private void introduce(ReaderProxy reader) {
    reader.introduced = SteadyClock.nanoseconds();
    MessageBuilder message = to(reader);
    int to = reader.guid.entity();
    if (reader.start > 1) message.gap(to, entity, 1, reader.start);
    // The first heartbeat ends where the reader begins, so that it knows what it has to wait for,
    // whatever is lost later. The second one tells of all there is: with the first alone the reader
    // could believe that the writer has begun anew.
    long last = reader.wantsAll ? sent : reader.start - 1;
    long first = Math.min(history.first(), last + 1);
    boolean more = last < sent;
    message.heartbeat(to, entity, first, last, ++heartbeatCount, more, false);
    if (more) heartbeat(message, to, false, false);
  }

  private void heartbeatIsDue() {
    long now = SteadyClock.nanoseconds();
    boolean waiting = false;
    for (ReaderProxy each : readers.values()) {
      if (!each.reliable || each.isKnown && each.acknowledged >= sent) continue;
      waiting = true;
      each.lags |= now - each.progress > LAG;
      if (each.isKnown) tell(each);
      else introduce(each);
    }
    if (waiting) {
      heartbeats.in(heartbeatPeriod);
      heartbeatPeriod = Math.min(SLOWEST_HEARTBEAT, heartbeatPeriod * 2);
      room.run();
    }
    pump();
  }

  // What is answered

  /** A reader says what it has and what it misses. */
  void received(Guid guid, Submessage.Acknowledgement answer) {
    ReaderProxy reader = readers.get(guid);
    if (reader == null || !reader.reliable || !reader.isNew(answer.count())) return;
    long now = SteadyClock.nanoseconds();
    SequenceSet missing = answer.missing();
    boolean wasKnown = reader.isKnown;
    long before = reader.acknowledged;
    // One that has more than was sent speaks of a writer that was there before this one.
    long has = Math.min(sent, missing.base() - 1);
    reader.isKnown = true;
    reader.acknowledged = Math.max(reader.start - 1, has);
    if (reader.acknowledged > before || reader.acknowledged == sent) {
      reader.lags = false;
      reader.progress = now;
      heartbeatPeriod = FIRST_HEARTBEAT;
    }
    boolean isLost =
        has < reader.start - 1 || missing.size() == 0 && (!wasKnown || !answer.answerIsOptional());
    // Not at once again: a reader that does not understand it would answer as fast as it is told.
    if (isLost && now - reader.introduced > FIRST_HEARTBEAT) introduce(reader);
    else if (!wasKnown && reader.acknowledged < sent && missing.isEmpty()) tell(reader);
    if (missing.isEmpty()) {
      if (reader.acknowledged > before) {
        window.grow();
        pacing.faster(now);
      }
    } else {
      window.shrink(now);
      sendMissing(reader, missing);
    }
    if (reader.acknowledged < sent) heartbeats.atLatestIn(heartbeatPeriod);
    acknowledgedMore();
    pump();
  }

  private void sendMissing(ReaderProxy reader, SequenceSet missing) {
    int to = reader.guid.entity();
    Outbox outbox = environment.outbox;
    GuidPrefix prefix = reader.guid.prefix();
    int bytes = 0;
    List<Change> fragmented = new ArrayList<>();
    long end = Math.min(sent + 1, missing.base() + missing.size());
    for (long each = missing.base(); each < end && bytes < AGAIN_AT_ONCE; each++) {
      if (!missing.contains(each)) continue;
      Change change = each < reader.start ? null : history.get(each);
      if (change != null && isFragmented(change)) {
        fragmented.add(change);
        continue;
      }
      int size = MessageBuilder.OVERHEAD + (change == null ? 0 : change.size());
      bytes += size;
      MessageBuilder message = outbox.to(reader.address, prefix, size);
      if (change != null) {
        message.data(to, entity, change);
      } else {
        long next = endOfGap(reader, each);
        message.gap(to, entity, each, next);
        each = next - 1;
      }
    }
    tell(reader);
    for (Change each : fragmented) sendAgain(reader, each);
  }

  /** The first number after {@code sequence}, which is no more, that the reader can have. */
  private long endOfGap(ReaderProxy reader, long sequence) {
    Change next = history.from(Math.max(sequence, reader.start));
    return Math.max(sequence + 1, next == null ? sent + 1 : Math.min(next.sequence(), sent + 1));
  }

  private void sendAgain(ReaderProxy reader, Change change) {
    if (isFragmented(change)) {
      BitSet all = new BitSet();
      all.set(0, change.fragments(environment.options.fragmentSize()));
      reader.requested.putIfAbsent(change.sequence(), all);
    } else {
      environment
          .outbox
          .to(reader.address, reader.guid.prefix(), change.size() + MessageBuilder.OVERHEAD)
          .data(reader.guid.entity(), entity, change);
    }
  }

  /** A reader misses fragments. */
  void received(Guid guid, Submessage.FragmentRequest request) {
    ReaderProxy reader = readers.get(guid);
    if (reader == null || !reader.reliable) return;
    Change change = history.get(request.sequence());
    if (change == null || !isFragmented(change)) {
      if (request.sequence() <= sent) {
        to(reader)
            .gap(guid.entity(), entity, request.sequence(), endOfGap(reader, request.sequence()));
      }
      return;
    }
    int sentOfIt =
        change.sequence() <= sent
            ? Integer.MAX_VALUE
            : change.sequence() == fragmentsOf ? sentFragments : 0;
    int end = Math.min(sentOfIt, change.fragments(environment.options.fragmentSize()));
    SequenceSet missing = request.missing();
    BitSet again = reader.requested.computeIfAbsent(change.sequence(), key -> new BitSet());
    for (long each = missing.base(); each < missing.base() + missing.size(); each++)
      if (missing.contains(each) && each >= 1 && each <= end) again.set((int) each - 1);
    pacing.slower(SteadyClock.nanoseconds());
    pump();
  }

  private void acknowledgedMore() {
    discardAcknowledged();
    room.run();
  }

  private void discardAcknowledged() {
    long acknowledged = leastAcknowledged(true);
    if (!qos.transientLocal()) history.removeUpTo(Math.min(acknowledged, leastRequested() - 1));
    // Who comes later need not know of instances that were disposed of.
    while (!disposals.isEmpty() && disposals.firstKey() <= acknowledged) {
      Map.Entry<Long, Guid> entry = disposals.pollFirstEntry();
      history.remove(entry.getKey());
      newest.remove(entry.getValue(), entry.getKey());
    }
  }

  /** The first sample of which a reader at best effort still waits for fragments. */
  private long leastRequested() {
    long least = Long.MAX_VALUE;
    for (ReaderProxy each : readers.values())
      if (!each.requested.isEmpty()) least = Math.min(least, each.requested.firstKey());
    return least;
  }
}

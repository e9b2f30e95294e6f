package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.time.SteadyClock;

/**
 * What a reader knows of one of its writers: which samples it has, which came too early, which are
 * missing. The lock of the participant guards it.
 */
final class WriterProxy {
  private static final long FIRST_GREETING = TimeUnit.MILLISECONDS.toNanos(10);
  private static final long SLOWEST_GREETING = TimeUnit.SECONDS.toNanos(1);
  private static final long FIRST_ASKING = TimeUnit.MILLISECONDS.toNanos(50);
  private static final long SLOWEST_ASKING = TimeUnit.SECONDS.toNanos(2);

  /** What is missing is asked for at most so often, unless something came meanwhile. */
  private static final long PATIENCE = TimeUnit.MILLISECONDS.toNanos(3);

  /**
   * Greetings, after which a writer that tells all readers at once is believed to mean this one.
   */
  private static final int GREETINGS = 3;

  /** What was overtaken on its way comes within that time after what overtook it. */
  private static final long OVERTAKEN = TimeUnit.MILLISECONDS.toNanos(5);

  /** How many samples may come too early. */
  private static final int AHEAD = 4096;

  /** Of how many samples fragments are kept. */
  private static final int ASSEMBLIES = 16;

  private final Environment environment;
  private final int reader;
  private final Guid writer;
  private final boolean reliable;
  private final boolean fromBeginning;
  private final boolean keepsOld;
  private final boolean isAutomatic;
  private final long lease;
  private final InetSocketAddress address;
  private final SampleSink sink;
  private final Reactor.Timer timer;

  /** Samples that came before an earlier one; empty: those that will never come. */
  private final TreeMap<Long, Optional<Sample>> ahead = new TreeMap<>();

  private final TreeMap<Long, Assembly> assemblies = new TreeMap<>();

  /**
   * The next sample to hand over; nothing is handed over before the writer has said where it
   * begins.
   */
  private long expected = 1;

  private boolean isKnown;
  private long announced;
  private int greetings;
  private long greetingPeriod = FIRST_GREETING;
  private long askPeriod = FIRST_ASKING;
  private int count;
  private long asked;
  private long askedFrom;
  private long lastAlive = SteadyClock.nanoseconds();
  private boolean hasGoneBack;
  private boolean isAlive = true;
  private long goneBackCount;
  private long goneBackSince;

  WriterProxy(
      Environment environment,
      int reader,
      EndpointQos requested,
      Guid writer,
      EndpointQos offered,
      InetSocketAddress address,
      SampleSink sink) {
    this.environment = environment;
    this.reader = reader;
    this.writer = writer;
    this.address = address;
    this.sink = sink;
    reliable = requested.reliable() && offered.reliable();
    fromBeginning = requested.transientLocal() && offered.transientLocal();
    keepsOld = offered.transientLocal();
    lease = requested.lease();
    isAutomatic = offered.liveliness() == EndpointQos.Liveliness.AUTOMATIC;
    isKnown = !reliable;
    timer = environment.reactor.timer("asking for samples", this::timeIsUp);
    if (reliable) greet();
  }

  Guid writer() {
    return writer;
  }

  void close() {
    timer.cancel();
    forgetAll();
  }

  private void forgetAll() {
    ahead.values().forEach(each -> each.ifPresent(this::giveBack));
    ahead.clear();
    assemblies.values().forEach(each -> environment.halfReceived.giveBack(each.size()));
    assemblies.clear();
  }

  private void giveBack(Sample sample) {
    environment.halfReceived.giveBack(sample.payload().capacity());
  }

  // Liveliness

  /** Something was heard of the writer, or its participant vouches for it. */
  void heard() {
    lastAlive = SteadyClock.nanoseconds();
  }

  /** Whether it has become alive or not alive since this was last asked. */
  boolean aliveChanges(long now) {
    boolean alive = lease == EndpointQos.INFINITE || now - lastAlive < lease;
    boolean changes = alive != isAlive;
    isAlive = alive;
    return changes;
  }

  boolean isAutomatic() {
    return isAutomatic;
  }

  boolean isAlive() {
    return isAlive;
  }

  // What arrives

  void received(Submessage.Data data, long time) {
    heard();
    if (isUseless(data.sequence())) return;
    if (!takeMemory(data.payload().remaining(), data.sequence())) return;
    byte[] bytes = new byte[data.payload().remaining()];
    data.payload().get(data.payload().position(), bytes);
    InlineQos qos = data.qos();
    take(
        new Sample(
            new SampleIdentity(writer, data.sequence()),
            time,
            ByteBuffer.wrap(bytes),
            qos.related(),
            qos.key(),
            qos.disposed()));
  }

  void received(Submessage.DataFragments part, long time) {
    heard();
    long sequence = part.sequence();
    if (isUseless(sequence) || part.size() > environment.options.largestSample()) return;
    Assembly assembly = assemblies.get(sequence);
    if (assembly == null) {
      assembly = begin(part);
      if (assembly == null) return;
    }
    assembly.add(part, time);
    if (!assembly.isComplete()) return;
    assemblies.remove(sequence);
    take(assembly.sample(writer, sequence));
  }

  private @Nullable Assembly begin(Submessage.DataFragments part) {
    // At best effort an old one will never be complete; otherwise the oldest are wanted first.
    if (assemblies.size() >= ASSEMBLIES) {
      if (reliable && part.sequence() > assemblies.lastKey()) return null;
      Map.Entry<Long, Assembly> gone =
          reliable ? assemblies.pollLastEntry() : assemblies.pollFirstEntry();
      environment.halfReceived.giveBack(gone.getValue().size());
    }
    if (!takeMemory(part.size(), part.sequence())) return null;
    Assembly assembly = new Assembly(part);
    assemblies.put(part.sequence(), assembly);
    return assembly;
  }

  /** Whether there is memory for that sample; later ones make room for it. */
  private boolean takeMemory(int bytes, long sequence) {
    while (!environment.halfReceived.take(bytes)) {
      if (ahead.isEmpty() || ahead.lastKey() <= sequence) return false;
      ahead.pollLastEntry().getValue().ifPresent(this::giveBack);
    }
    return true;
  }

  private boolean isUseless(long sequence) {
    if (!reliable) return sequence < expected;
    boolean tooFar =
        isKnown && sequence - expected >= AHEAD || ahead.size() >= AHEAD && sequence != expected;
    return tooFar || isKnown && sequence < expected || ahead.containsKey(sequence);
  }

  /** A sample is complete; its bytes have been taken from the budget. */
  private void take(Sample sample) {
    long sequence = sample.identity().sequence();
    if (!reliable) {
      giveBack(sample);
      if (expected > 1 && sequence > expected) sink.lost(writer, sequence - expected);
      expected = sequence + 1;
      discardAssemblies();
      sink.deliver(sample);
      return;
    }
    announced = Math.max(announced, sequence);
    boolean isNext = isKnown && sequence == expected && ahead.isEmpty();
    if (isNext && sink.deliver(sample)) {
      giveBack(sample);
      handedOver();
      discardAssemblies();
      return;
    }
    ahead.put(sequence, Optional.of(sample));
    if (!isKnown && sequence == 1 && (fromBeginning || !keepsOld)) know(1);
    if (isKnown) deliverAhead();
  }

  /** Hands over what is next, as far as there is room for it. */
  private void deliverAhead() {
    while (!ahead.isEmpty() && ahead.firstKey() <= expected) {
      Map.Entry<Long, Optional<Sample>> entry = ahead.firstEntry();
      Optional<Sample> sample = entry.getValue();
      boolean isNext = entry.getKey() == expected;
      if (isNext && sample.isPresent() && !sink.deliver(sample.get())) return;
      sample.ifPresent(this::giveBack);
      ahead.pollFirstEntry();
      if (isNext) handedOver();
    }
    discardAssemblies();
  }

  private void handedOver() {
    expected++;
    askPeriod = FIRST_ASKING;
  }

  private void discardAssemblies() {
    while (!assemblies.isEmpty() && assemblies.firstKey() < expected)
      environment.halfReceived.giveBack(assemblies.pollFirstEntry().getValue().size());
  }

  void received(Submessage.Gap gap) {
    if (!reliable) return;
    long base = gap.set().base();
    if (gap.start() <= expected && base > expected) skipTo(base, false);
    if (!isKnown && gap.start() <= 1 && base > 1) know(base);
    // Beyond something that is missing yet, only what is near is remembered; the rest will be said
    // again.
    if (gap.start() > expected && base - gap.start() <= SequenceSet.LARGEST)
      for (long each = gap.start(); each < base; each++) willNotCome(each);
    for (long each = base; each < base + gap.set().size(); each++)
      if (gap.set().contains(each)) willNotCome(each);
    if (isKnown) deliverAhead();
  }

  private void willNotCome(long sequence) {
    if (sequence >= expected && sequence - expected < AHEAD && ahead.size() < AHEAD)
      ahead.putIfAbsent(sequence, Optional.empty());
  }

  private void skipTo(long sequence, boolean lost) {
    // What arrived of them all the same is handed over.
    while (expected < sequence) {
      Map.Entry<Long, Optional<Sample>> next = ahead.firstEntry();
      if (!isKnown || next == null || next.getKey() >= sequence) {
        if (lost && isKnown) sink.lost(writer, sequence - expected);
        expected = sequence;
      } else {
        if (lost && next.getKey() > expected) sink.lost(writer, next.getKey() - expected);
        expected = Math.max(expected, next.getKey());
        long before = expected;
        deliverAhead();
        if (expected == before) return;
      }
    }
    if (isKnown) deliverAhead();
  }

  void received(Submessage.Heartbeat heartbeat) {
    if (isAutomatic || heartbeat.liveliness()) heard();
    if (!reliable || hasRestarted(heartbeat)) return;
    if (!isKnown) {
      boolean meansUs = heartbeat.reader() == reader || greetings >= GREETINGS;
      if (!meansUs && !fromBeginning) return;
      know(fromBeginning || !keepsOld ? heartbeat.first() : afterOld(heartbeat));
    }
    announced = Math.max(announced, heartbeat.last());
    if (heartbeat.first() > expected) skipTo(heartbeat.first(), true);
    if (expected <= announced) askForMissing(!heartbeat.answerIsOptional());
    else if (!heartbeat.answerIsOptional()) acknowledge(SequenceSet.empty(expected));
  }

  void received(Submessage.FragmentHeartbeat heartbeat) {
    if (!reliable || !isKnown) return;
    announced = Math.max(announced, heartbeat.sequence());
    if (assemblies.containsKey(heartbeat.sequence())) askForMissing(false);
  }

  /**
   * Where a writer begins that also has samples from before this reader: after them, but with what
   * came since.
   */
  private long afterOld(Submessage.Heartbeat heartbeat) {
    long begin = heartbeat.last() + 1;
    if (!ahead.isEmpty()) begin = Math.min(begin, ahead.firstKey());
    if (!assemblies.isEmpty()) begin = Math.min(begin, assemblies.firstKey());
    return begin;
  }

  private void know(long begin) {
    isKnown = true;
    timer.cancel();
    // What arrived before the writer said where it begins is not thrown away, even if the writer no
    // longer has it.
    expected = Math.max(expected, ahead.isEmpty() ? begin : Math.min(begin, ahead.firstKey()));
    deliverAhead();
    skipTo(begin, true);
  }

  /**
   * Whether the writer has fewer samples than it had, and says so again after some time without
   * having said anything else: then it is another one with the same name, whose participant died
   * unheard, and all begins anew. (What a datagram that was overtaken says comes at once, and a
   * writer that tells where this reader begins says in the same datagram what there is.)
   */
  private boolean hasRestarted(Submessage.Heartbeat heartbeat) {
    boolean back = isKnown && heartbeat.last() < expected - 1;
    long now = SteadyClock.nanoseconds();
    if (!back || !hasGoneBack || heartbeat.count() <= goneBackCount) {
      if (back && !hasGoneBack) goneBackSince = now;
      hasGoneBack = back;
      goneBackCount = heartbeat.count();
      return back;
    }
    goneBackCount = heartbeat.count();
    if (now - goneBackSince < OVERTAKEN) return true;
    sink.restarted(writer);
    forgetAll();
    expected = fromBeginning || !keepsOld ? heartbeat.first() : heartbeat.last() + 1;
    announced = heartbeat.last();
    hasGoneBack = false;
    return false;
  }

  // What is answered

  /**
   * Says hello to a writer that has said nothing yet: it may not know that this reader is waiting.
   */
  private void greet() {
    greetings++;
    acknowledge(SequenceSet.empty(expected));
    timer.in(greetingPeriod);
    greetingPeriod = Math.min(SLOWEST_GREETING, greetingPeriod * 2);
  }

  private void timeIsUp() {
    if (!isKnown && !fromBeginning && !ahead.isEmpty()) {
      // Not all say where they begin. What is asked for that should not come is answered by a gap.
      if (!keepsOld) know(Math.max(1, ahead.firstKey() - SequenceSet.LARGEST + 1));
      else if (greetings >= GREETINGS) know(ahead.firstKey());
    }
    if (!isKnown) greet();
    else if (expected <= announced) askForMissing(true);
  }

  /** There is room again: what waited is handed over, and the writer told. */
  void resume() {
    if (!reliable || !isKnown || expected > announced) return;
    deliverAhead();
    askForMissing(true);
  }

  private void askForMissing(boolean answer) {
    long now = SteadyClock.nanoseconds();
    // What waits for room is not missing.
    boolean waitsForRoom = ahead.containsKey(expected);
    boolean justAsked = askedFrom == expected && now - asked < PATIENCE;
    if (justAsked && !answer) {
      if (!timer.isSet()) timer.in(PATIENCE);
      return;
    }
    int size = (int) Math.min(SequenceSet.LARGEST, announced - expected + 1);
    SequenceSet missing =
        waitsForRoom ? SequenceSet.empty(expected) : SequenceSet.from(expected, size);
    for (int i = 0; i < missing.size(); i++) {
      long sequence = expected + i;
      if (!ahead.containsKey(sequence) && !assemblies.containsKey(sequence)) missing.add(sequence);
    }
    if (justAsked && !missing.isEmpty()) missing = SequenceSet.empty(expected);
    asked = now;
    askedFrom = expected;
    acknowledge(missing);
    if (!missing.isEmpty()) {
      // Not all writers repeat what they have if an answer is lost.
      timer.in(askPeriod);
      askPeriod = Math.min(SLOWEST_ASKING, askPeriod * 2);
    }
    if (!justAsked) askForFragments(now);
  }

  private void askForFragments(long now) {
    for (Map.Entry<Long, Assembly> entry : assemblies.entrySet()) {
      if (entry.getKey() > announced) return;
      // They may still be on their way.
      if (now - entry.getValue().arrived() < PATIENCE) {
        timer.atLatestIn(PATIENCE);
        continue;
      }
      SequenceSet missing = entry.getValue().missing();
      environment
          .outbox
          .to(address, writer.prefix(), MessageBuilder.SET_SIZE)
          .fragmentRequest(reader, writer.entity(), entry.getKey(), missing, ++count);
    }
  }

  private void acknowledge(SequenceSet missing) {
    environment
        .outbox
        .to(address, writer.prefix(), MessageBuilder.SET_SIZE)
        .acknowledgement(reader, writer.entity(), missing, ++count, isKnown && missing.isEmpty());
  }
}

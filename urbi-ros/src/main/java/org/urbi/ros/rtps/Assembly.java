package org.urbi.ros.rtps;

import java.nio.ByteBuffer;
import java.util.BitSet;
import org.urbi.ros.time.SteadyClock;

/** A sample of which some fragments have arrived. */
final class Assembly {
  private final byte[] bytes;
  private final int fragmentSize;
  private final int fragments;
  private final BitSet there = new BitSet();
  private InlineQos qos;
  private long time;
  private long arrived = SteadyClock.nanoseconds();

  Assembly(Submessage.DataFragments first) {
    bytes = new byte[first.size()];
    fragmentSize = first.fragmentSize();
    fragments = (int) ((first.size() + (long) fragmentSize - 1) / fragmentSize);
    qos = first.qos();
  }

  /** Adds what has arrived, unless it contradicts what came before. */
  void add(Submessage.DataFragments part, long sourceTime) {
    if (part.size() != bytes.length || part.fragmentSize() != fragmentSize) return;
    int first = part.first() - 1;
    ByteBuffer payload = part.payload();
    payload.get(payload.position(), bytes, first * fragmentSize, payload.remaining());
    there.set(first, Math.min(fragments, first + part.count()));
    if (qos.isEmpty()) qos = part.qos();
    time = sourceTime;
    arrived = SteadyClock.nanoseconds();
  }

  boolean isComplete() {
    return there.cardinality() == fragments;
  }

  /** When the last fragment arrived, in terms of {@link SteadyClock#nanoseconds}. */
  long arrived() {
    return arrived;
  }

  int size() {
    return bytes.length;
  }

  /** The first fragments that are missing, the first one being 1. */
  SequenceSet missing() {
    int first = there.nextClearBit(0);
    SequenceSet missing = SequenceSet.from(first + 1, fragments - first);
    for (int i = 0; i < missing.size(); i++) if (!there.get(first + i)) missing.add(first + 1 + i);
    return missing;
  }

  Sample sample(Guid writer, long sequence) {
    return new Sample(
        new SampleIdentity(writer, sequence),
        time,
        ByteBuffer.wrap(bytes),
        qos.related(),
        qos.key(),
        qos.disposed());
  }
}

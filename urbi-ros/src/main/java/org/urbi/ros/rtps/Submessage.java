package org.urbi.ros.rtps;

import java.nio.ByteBuffer;

/**
 * What a datagram says to a reader or to a writer. Payloads are part of the datagram: who keeps
 * them copies them.
 */
sealed interface Submessage {
  /** The reader it is for or comes from; {@link EntityId#UNKNOWN}: all that are matched. */
  int reader();

  int writer();

  /** To readers. */
  sealed interface FromWriter extends Submessage {}

  /** To a writer. */
  sealed interface FromReader extends Submessage {}

  /** A whole sample; {@code key}: the payload is only its key. */
  record Data(int reader, int writer, long sequence, InlineQos qos, ByteBuffer payload, boolean key)
      implements FromWriter {}

  /** Some fragments of a sample, the first one being 1; {@code size}: that of the whole sample. */
  record DataFragments(
      int reader,
      int writer,
      long sequence,
      InlineQos qos,
      int first,
      int count,
      int fragmentSize,
      int size,
      ByteBuffer payload)
      implements FromWriter {}

  /** Which samples the writer has. */
  record Heartbeat(
      int reader,
      int writer,
      long first,
      long last,
      int count,
      boolean answerIsOptional,
      boolean liveliness)
      implements FromWriter {}

  /** Which fragments of a sample it has. */
  record FragmentHeartbeat(int reader, int writer, long sequence, int lastFragment, int count)
      implements FromWriter {}

  /**
   * Samples that are no more: those from {@code start} to the base of the set, and those in the
   * set.
   */
  record Gap(int reader, int writer, long start, SequenceSet set) implements FromWriter {}

  /** What came before the base is there; what is in the set is missing. */
  record Acknowledgement(
      int reader, int writer, SequenceSet missing, int count, boolean answerIsOptional)
      implements FromReader {}

  /** Fragments that are missing. */
  record FragmentRequest(int reader, int writer, long sequence, SequenceSet missing, int count)
      implements FromReader {}
}

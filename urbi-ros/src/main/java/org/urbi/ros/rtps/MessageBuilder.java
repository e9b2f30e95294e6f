package org.urbi.ros.rtps;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Puts submessages of this participant into a datagram. The lock of the participant guards it. */
final class MessageBuilder {
  /** The largest datagram of UDP over IPv4. */
  static final int LARGEST = 65507;

  /**
   * What a sample needs in a datagram beside its payload, at most: headers, time, destination,
   * parameters, padding.
   */
  static final int OVERHEAD = 256;

  /** What a heartbeat takes. */
  static final int HEARTBEAT_SIZE = 32;

  /** What a fixed part and a set of numbers take, at most: an acknowledgement, a gap. */
  static final int SET_SIZE = 80;

  private static final int LITTLE = 0x01;
  private static final int VERSION = 0x0203;

  /** No vendor has this number. */
  static final int VENDOR = 0x01f5;

  private final GuidPrefix own;
  private final ByteBuffer out = ByteBuffer.allocateDirect(LARGEST).order(ByteOrder.LITTLE_ENDIAN);
  private long time;

  MessageBuilder(GuidPrefix own) {
    this.own = own;
  }

  /** A new datagram, for everybody. */
  MessageBuilder begin() {
    out.clear();
    Wire.putBigEndian(out, MessageParser.MAGIC);
    out.put((byte) (VERSION >> 8)).put((byte) VERSION).put((byte) (VENDOR >> 8)).put((byte) VENDOR);
    own.write(out);
    time = 0;
    return this;
  }

  /** A new datagram, for one participant. */
  MessageBuilder begin(GuidPrefix destination) {
    begin();
    int start = submessage(MessageParser.INFO_DESTINATION, 0);
    destination.write(out);
    end(start);
    return this;
  }

  /** How many bytes there are. */
  int size() {
    return out.position();
  }

  MessageBuilder data(int reader, int writer, Change change) {
    time(change.time());
    boolean key = change.qos().disposed();
    boolean parameters = !change.qos().isEmpty();
    int start = submessage(MessageParser.DATA, (parameters ? 0x02 : 0) | (key ? 0x08 : 0x04));
    out.putShort((short) 0).putShort((short) 16);
    endpoints(reader, writer);
    Wire.putSequence(out, change.sequence());
    if (parameters) change.qos().write(out);
    out.put(change.payload().duplicate());
    pad();
    end(start);
    return this;
  }

  /** One fragment, the first one being 0. */
  MessageBuilder fragment(int reader, int writer, Change change, int index, int fragmentSize) {
    time(change.time());
    boolean parameters = !change.qos().isEmpty();
    int start = submessage(MessageParser.DATA_FRAGMENTS, parameters ? 0x02 : 0);
    out.putShort((short) 0).putShort((short) 28);
    endpoints(reader, writer);
    Wire.putSequence(out, change.sequence());
    out.putInt(index + 1).putShort((short) 1).putShort((short) fragmentSize).putInt(change.size());
    if (parameters) change.qos().write(out);
    int from = index * fragmentSize;
    ByteBuffer payload = change.payload();
    out.put(payload.slice(payload.position() + from, Math.min(fragmentSize, change.size() - from)));
    pad();
    end(start);
    return this;
  }

  MessageBuilder heartbeat(
      int reader,
      int writer,
      long first,
      long last,
      int count,
      boolean answerIsOptional,
      boolean liveliness) {
    int start =
        submessage(
            MessageParser.HEARTBEAT, (answerIsOptional ? 0x02 : 0) | (liveliness ? 0x04 : 0));
    endpoints(reader, writer);
    Wire.putSequence(out, first);
    Wire.putSequence(out, last);
    out.putInt(count);
    end(start);
    return this;
  }

  /** Says that the samples from {@code from} up to {@code end}, which is excluded, are gone. */
  MessageBuilder gap(int reader, int writer, long from, long end) {
    int start = submessage(MessageParser.GAP, 0);
    endpoints(reader, writer);
    Wire.putSequence(out, from);
    SequenceSet.empty(end).writeSamples(out);
    end(start);
    return this;
  }

  MessageBuilder acknowledgement(
      int reader, int writer, SequenceSet missing, int count, boolean isFinal) {
    int start = submessage(MessageParser.ACKNACK, isFinal ? 0x02 : 0);
    endpoints(reader, writer);
    missing.writeSamples(out);
    out.putInt(count);
    end(start);
    return this;
  }

  MessageBuilder fragmentRequest(
      int reader, int writer, long sequence, SequenceSet missing, int count) {
    int start = submessage(MessageParser.NACK_FRAGMENTS, 0);
    endpoints(reader, writer);
    Wire.putSequence(out, sequence);
    missing.writeFragments(out);
    out.putInt(count);
    end(start);
    return this;
  }

  /** The datagram. It is overwritten by the next one. */
  ByteBuffer finish() {
    return out.flip();
  }

  private void time(long nanos) {
    if (nanos == time) return;
    time = nanos;
    int start = submessage(MessageParser.INFO_TIME, 0);
    Wire.putTime(out, nanos);
    end(start);
  }

  private void endpoints(int reader, int writer) {
    Wire.putBigEndian(out, reader);
    Wire.putBigEndian(out, writer);
  }

  private int submessage(int kind, int flags) {
    out.put((byte) kind).put((byte) (flags | LITTLE)).putShort((short) 0);
    return out.position();
  }

  private void pad() {
    while (out.position() % 4 != 0) out.put((byte) 0);
  }

  private void end(int start) {
    out.putShort(start - 2, (short) (out.position() - start));
  }
}

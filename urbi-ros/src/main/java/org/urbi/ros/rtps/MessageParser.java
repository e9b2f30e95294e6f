package org.urbi.ros.rtps;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Takes datagrams apart. Whatever they contain, nothing is allocated that is larger than the
 * datagram.
 */
final class MessageParser {
  /** Who gets the submessages, in their order. */
  interface Handler {
    void submessage(MessageSource source, Submessage submessage);
  }

  static final int MAGIC = 'R' << 24 | 'T' << 16 | 'P' << 8 | 'S';
  static final int HEADER = 20;
  static final int PAD = 0x01;
  static final int ACKNACK = 0x06;
  static final int HEARTBEAT = 0x07;
  static final int GAP = 0x08;
  static final int INFO_TIME = 0x09;
  static final int INFO_SOURCE = 0x0c;
  static final int INFO_DESTINATION = 0x0e;
  static final int NACK_FRAGMENTS = 0x12;
  static final int HEARTBEAT_FRAGMENT = 0x13;
  static final int DATA = 0x15;
  static final int DATA_FRAGMENTS = 0x16;

  private static final int LITTLE = 0x01;
  private static final int SECOND = 0x02;
  private static final int THIRD = 0x04;
  private static final int FOURTH = 0x08;
  private static final int MAJOR_VERSION = 2;

  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0);

  private MessageParser() {}

  /**
   * Hands over what {@code datagram} contains.
   *
   * @throws MalformedException for what is no RTPS; what came before in the datagram has been
   *     handed over
   */
  static void parse(ByteBuffer datagram, Handler handler) throws MalformedException {
    try {
      datagram.order(ByteOrder.BIG_ENDIAN);
      if (datagram.remaining() < HEADER || datagram.getInt() != MAGIC)
        throw new MalformedException("no RTPS");
      int major = datagram.get();
      if (major != MAJOR_VERSION) throw new MalformedException("RTPS of version " + major);
      // The minor version and the vendor change nothing of what is read here.
      datagram.position(datagram.position() + 3);
      MessageSource source = new MessageSource(GuidPrefix.read(datagram), GuidPrefix.UNKNOWN, 0);
      while (datagram.remaining() >= 4) source = submessage(datagram, source, handler);
    } catch (BufferUnderflowException e) {
      throw new MalformedException("truncated");
    }
  }

  private static MessageSource submessage(
      ByteBuffer datagram, MessageSource source, Handler handler) throws MalformedException {
    int kind = datagram.get();
    int flags = datagram.get();
    ByteOrder order = (flags & LITTLE) != 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
    int length = datagram.order(order).getShort() & 0xffff;
    // Of a length of 0: the rest of the datagram, except for those that may be empty.
    if (length == 0 && kind != INFO_TIME && kind != PAD) length = datagram.remaining();
    if (length > datagram.remaining())
      throw new MalformedException("submessage longer than its message");
    ByteBuffer in = datagram.slice(datagram.position(), length).order(order);
    datagram.position(datagram.position() + length);
    switch (kind) {
      case INFO_TIME -> {
        return source.at((flags & SECOND) != 0 ? 0 : Wire.time(in));
      }
      case INFO_DESTINATION -> {
        return source.to(GuidPrefix.read(in));
      }
      case INFO_SOURCE -> {
        in.getLong();
        return source.from(GuidPrefix.read(in));
      }
      case DATA -> handler.submessage(source, data(in, flags));
      case DATA_FRAGMENTS -> handler.submessage(source, fragments(in, flags));
      case HEARTBEAT -> handler.submessage(source, heartbeat(in, flags));
      case HEARTBEAT_FRAGMENT -> handler.submessage(source, fragmentHeartbeat(in));
      case GAP -> handler.submessage(source, gap(in));
      case ACKNACK -> handler.submessage(source, acknowledgement(in, flags));
      case NACK_FRAGMENTS -> handler.submessage(source, fragmentRequest(in));
      // Pads, replies to other addresses, and what vendors add.
      default -> {}
    }
    return source;
  }

  private static Submessage data(ByteBuffer in, int flags) throws MalformedException {
    int beforeQos = offset(in, 16);
    int reader = Wire.bigEndian(in);
    int writer = Wire.bigEndian(in);
    long sequence = Wire.sampleSequence(in);
    in.position(beforeQos);
    InlineQos qos = (flags & SECOND) != 0 ? InlineQos.read(in) : InlineQos.NONE;
    boolean key = (flags & FOURTH) != 0;
    boolean some = key || (flags & THIRD) != 0;
    return new Submessage.Data(reader, writer, sequence, qos, some ? in.slice() : NOTHING, key);
  }

  private static Submessage fragments(ByteBuffer in, int flags) throws MalformedException {
    int beforeQos = offset(in, 28);
    int reader = Wire.bigEndian(in);
    int writer = Wire.bigEndian(in);
    long sequence = Wire.sampleSequence(in);
    int first = in.getInt();
    int count = in.getShort() & 0xffff;
    int fragmentSize = in.getShort() & 0xffff;
    int size = in.getInt();
    in.position(beforeQos);
    InlineQos qos = (flags & SECOND) != 0 ? InlineQos.read(in) : InlineQos.NONE;
    // Sizes and numbers beyond 2^31 are negative here, and refused: nobody keeps such samples.
    if (first < 1 || count < 1 || fragmentSize < 1 || size < 1)
      throw new MalformedException("fragments of nothing");
    long begin = (first - 1L) * fragmentSize;
    long end = Math.min(size, begin + (long) count * fragmentSize);
    if (begin >= size || end - begin > in.remaining())
      throw new MalformedException("fragments outside of their sample");
    ByteBuffer payload = in.slice(in.position(), (int) (end - begin));
    return new Submessage.DataFragments(
        reader, writer, sequence, qos, first, count, fragmentSize, size, payload);
  }

  /**
   * Where the parameters begin, after a header of at least {@code smallest} bytes; then the header
   * is next.
   */
  private static int offset(ByteBuffer in, int smallest) throws MalformedException {
    in.getShort();
    int offset = in.getShort() & 0xffff;
    if (offset < smallest || offset > in.remaining())
      throw new MalformedException("parameters outside of their message");
    return in.position() + offset;
  }

  private static Submessage heartbeat(ByteBuffer in, int flags) throws MalformedException {
    int reader = Wire.bigEndian(in);
    int writer = Wire.bigEndian(in);
    long first = Wire.sequence(in);
    long last = Wire.sequence(in);
    // Empty histories end before they begin, and some begin at 0.
    if (last < first - 1) throw new MalformedException("heartbeat that ends before it begins");
    int count = in.getInt();
    return new Submessage.Heartbeat(
        reader,
        writer,
        Math.max(1, first),
        last,
        count,
        (flags & SECOND) != 0,
        (flags & THIRD) != 0);
  }

  private static Submessage fragmentHeartbeat(ByteBuffer in) throws MalformedException {
    return new Submessage.FragmentHeartbeat(
        Wire.bigEndian(in), Wire.bigEndian(in), Wire.sampleSequence(in), in.getInt(), in.getInt());
  }

  private static Submessage gap(ByteBuffer in) throws MalformedException {
    return new Submessage.Gap(
        Wire.bigEndian(in), Wire.bigEndian(in), Wire.sequence(in), SequenceSet.readSamples(in));
  }

  private static Submessage acknowledgement(ByteBuffer in, int flags) throws MalformedException {
    return new Submessage.Acknowledgement(
        Wire.bigEndian(in),
        Wire.bigEndian(in),
        SequenceSet.readSamples(in),
        in.getInt(),
        (flags & SECOND) != 0);
  }

  private static Submessage fragmentRequest(ByteBuffer in) throws MalformedException {
    return new Submessage.FragmentRequest(
        Wire.bigEndian(in),
        Wire.bigEndian(in),
        Wire.sampleSequence(in),
        SequenceSet.readFragments(in),
        in.getInt());
  }
}

package org.urbi.ros.rtps;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Values as RTPS writes them. Reading beyond the end throws {@link
 * java.nio.BufferUnderflowException}.
 */
final class Wire {
  /** Longer than any name of ROS, whose limit is 255. */
  static final int LONGEST_NAME = 1024;

  /** Greater ones would overflow what is computed with them. */
  private static final long GREATEST_SEQUENCE = 1L << 60;

  private static final long NANOS = 1_000_000_000L;
  private static final long FRACTION = 0xffffffffL;
  private static final int INFINITE_SECONDS = 0x7fffffff;

  private Wire() {}

  static int bigEndian(ByteBuffer in) {
    int value = in.getInt();
    return in.order() == ByteOrder.BIG_ENDIAN ? value : Integer.reverseBytes(value);
  }

  static void putBigEndian(ByteBuffer out, int value) {
    out.putInt(out.order() == ByteOrder.BIG_ENDIAN ? value : Integer.reverseBytes(value));
  }

  static long unsigned(int value) {
    return value & FRACTION;
  }

  /** A number that may be 0, as those of an empty history are. */
  static long sequence(ByteBuffer in) throws MalformedException {
    long value = (long) in.getInt() << 32 | unsigned(in.getInt());
    if (value < 0 || value > GREATEST_SEQUENCE)
      throw new MalformedException("sequence number out of range");
    return value;
  }

  /** The number of a sample: at least 1. */
  static long sampleSequence(ByteBuffer in) throws MalformedException {
    long value = sequence(in);
    if (value == 0) throw new MalformedException("sequence number 0");
    return value;
  }

  static void putSequence(ByteBuffer out, long value) {
    out.putInt((int) (value >>> 32)).putInt((int) value);
  }

  /** Nanoseconds; {@link EndpointQos#INFINITE} for what has no end. */
  static long duration(ByteBuffer in) {
    int seconds = in.getInt();
    long fraction = unsigned(in.getInt());
    if (seconds == INFINITE_SECONDS || seconds < 0) return EndpointQos.INFINITE;
    return seconds * NANOS + (fraction * NANOS >>> 32);
  }

  static void putDuration(ByteBuffer out, long nanos) {
    if (nanos == EndpointQos.INFINITE) {
      out.putInt(INFINITE_SECONDS).putInt(-1);
    } else {
      out.putInt((int) Math.min(nanos / NANOS, INFINITE_SECONDS - 1)).putInt(fraction(nanos));
    }
  }

  /** Nanoseconds since 1970. */
  static long time(ByteBuffer in) {
    long seconds = unsigned(in.getInt());
    return seconds * NANOS + (unsigned(in.getInt()) * NANOS >>> 32);
  }

  static void putTime(ByteBuffer out, long nanos) {
    out.putInt((int) (nanos / NANOS)).putInt(fraction(nanos));
  }

  /** Rounded up, so that reading gives the same nanosecond again. */
  private static int fraction(long nanos) {
    return (int) Math.min(((nanos % NANOS << 32) + NANOS - 1) / NANOS, FRACTION);
  }

  static String string(ByteBuffer in) throws MalformedException {
    int length = in.getInt();
    if (length < 0 || length > LONGEST_NAME || length > in.remaining())
      throw new MalformedException("string too long");
    byte[] bytes = new byte[length];
    in.get(bytes);
    // What ends it is counted; some forget it.
    int end = length > 0 && bytes[length - 1] == 0 ? length - 1 : length;
    return new String(bytes, 0, end, StandardCharsets.UTF_8);
  }

  static void putString(ByteBuffer out, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    out.putInt(bytes.length + 1).put(bytes).put((byte) 0);
  }
}

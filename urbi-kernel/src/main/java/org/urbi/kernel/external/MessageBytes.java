package org.urbi.kernel.external;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.urbi.kernel.error.Problem;
import urbi.wire.WireException;

/** A buffer of received bytes, which arrive in pieces of any size. */
final class MessageBytes {
  /** The size limit of a message, in bytes. */
  private static final int LONGEST = 256 << 20;

  private byte[] buffer = new byte[1 << 10];
  private int from;
  private int to;
  private long total;
  private long begun;

  void add(String bytes) {
    if (from == to) {
      from = 0;
      to = 0;
    }
    byte[] more = bytes.getBytes(StandardCharsets.ISO_8859_1);
    if (to + more.length > buffer.length) {
      System.arraycopy(buffer, from, buffer, 0, to - from);
      to -= from;
      from = 0;
      if (to + more.length > buffer.length) {
        buffer = Arrays.copyOf(buffer, Math.max(to + more.length, 2 * buffer.length));
      }
    }
    System.arraycopy(more, 0, buffer, to, more.length);
    to += more.length;
    total += more.length;
  }

  /** Whether that number of bytes has arrived. */
  boolean has(long count) {
    if (position() - begun + count > LONGEST) {
      throw new WireException(Problem.LONG_MESSAGE.text(LONGEST));
    }
    return to - from >= count;
  }

  /** Marks the start of a message, or its end. */
  void begin() {
    begun = position();
    if (from == to && buffer.length > 1 << 20) {
      // Free the space of a big message: most messages are small.
      buffer = new byte[1 << 10];
      from = 0;
      to = 0;
    }
  }

  /** How many bytes have been read. */
  long position() {
    return total - (to - from);
  }

  int peek(int offset) {
    return buffer[from + offset] & 0xff;
  }

  int octet() {
    return buffer[from++] & 0xff;
  }

  /** The two-byte number at an offset from the position. */
  int peekShort(int offset) {
    return peek(offset) << 8 | peek(offset + 1);
  }

  /** The four-byte number at an offset from the position. */
  long peekInt(int offset) {
    return (long) peekShort(offset) << 16 | peekShort(offset + 2);
  }

  long integer() {
    long value = peekInt(0);
    from += 4;
    return value;
  }

  /** Reads an eight-byte number, lowest byte first. */
  double number() {
    long bits = 0;
    for (int i = 7; i >= 0; i--) {
      bits = bits << 8 | peek(i);
    }
    from += 8;
    return Double.longBitsToDouble(bits);
  }

  byte[] bytes(int count) {
    byte[] taken = Arrays.copyOfRange(buffer, from, from + count);
    from += count;
    return taken;
  }

  String raw(int count) {
    return new String(bytes(count), StandardCharsets.ISO_8859_1);
  }
}

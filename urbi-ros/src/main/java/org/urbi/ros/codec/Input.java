package org.urbi.ros.codec;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Where a message is read from: it looks whether there are bytes before it takes any. */
final class Input {
  private final boolean cdr;
  private final int origin;
  private final ByteBuffer buffer;

  Input(boolean cdr, byte[] data, int offset, int length, ByteOrder order) {
    this.cdr = cdr;
    this.origin = offset;
    this.buffer = ByteBuffer.wrap(data, offset, length).order(order);
  }

  boolean isCdr() {
    return cdr;
  }

  /** The buffer, with a value of that size at its place. */
  ByteBuffer next(int size) {
    int padding = cdr ? -(buffer.position() - origin) & (size - 1) : 0;
    check((long) padding + size);
    return buffer.position(buffer.position() + padding);
  }

  private void check(long size) {
    if (size > buffer.remaining()) {
      throw new CodecException(
          "the message ends "
              + (size - buffer.remaining())
              + " bytes too early, at byte "
              + (buffer.limit() - origin));
    }
  }

  /**
   * The number of what follows.
   *
   * @param least how many bytes each has at least
   */
  int count(int least) {
    long count = next(Integer.BYTES).getInt() & 0xFFFF_FFFFL;
    if (least == 0) {
      // Nothing is sent of what is empty. There may be some, but not any number.
      if (count > buffer.limit() - origin) {
        throw new CodecException("the message is too short for " + count + " elements");
      }
    } else {
      check(count * least);
    }
    return (int) count;
  }

  byte[] bytes(int count) {
    check(count);
    byte[] bytes = new byte[count];
    buffer.get(bytes);
    return bytes;
  }

  String text(int count) {
    check(count);
    String text =
        new String(
            buffer.array(),
            buffer.arrayOffset() + buffer.position(),
            count,
            StandardCharsets.UTF_8);
    buffer.position(buffer.position() + count);
    return text;
  }

  int remaining() {
    return buffer.remaining();
  }
}

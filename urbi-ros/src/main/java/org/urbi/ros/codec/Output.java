package org.urbi.ros.codec;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/** Where a message is written; it grows. */
final class Output {
  private final boolean cdr;
  private final int origin;
  private ByteBuffer buffer;

  /**
   * @param cdr whether values are aligned to their size
   * @param origin how many bytes are left for what precedes the message
   * @param size how many bytes there will probably be
   */
  Output(boolean cdr, int origin, ByteOrder order, int size) {
    this.cdr = cdr;
    this.origin = origin;
    buffer = ByteBuffer.allocate(Math.max(origin, size)).order(order).position(origin);
  }

  boolean isCdr() {
    return cdr;
  }

  /** The buffer, with room for a value of that size at its place. */
  ByteBuffer room(int size) {
    int padding = cdr ? -(buffer.position() - origin) & (size - 1) : 0;
    reserve(padding + size);
    for (int i = 0; i < padding; i++) {
      buffer.put((byte) 0);
    }
    return buffer;
  }

  void put(byte[] bytes) {
    reserve(bytes.length);
    buffer.put(bytes);
  }

  /** The number of what follows. */
  void count(int count) {
    room(Integer.BYTES).putInt(count);
  }

  private void reserve(int more) {
    if (buffer.remaining() < more) {
      long size = Math.max(2L * buffer.capacity(), (long) buffer.position() + more);
      byte[] larger =
          Arrays.copyOf(buffer.array(), (int) Math.min(size, Integer.MAX_VALUE - Long.BYTES));
      buffer = ByteBuffer.wrap(larger).order(buffer.order()).position(buffer.position());
    }
  }

  byte[] bytes() {
    return buffer.hasRemaining()
        ? Arrays.copyOf(buffer.array(), buffer.position())
        : buffer.array();
  }
}

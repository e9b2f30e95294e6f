package org.urbi.ros.rcl;

import java.lang.foreign.Arena;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;

/** The bytes of a message in the memory of C, which grows as needed. For one thread at a time. */
final class SerializedBytes implements AutoCloseable {
  private static final long SIZE = 64;
  private static final long LENGTH = 8;
  private static final long CAPACITY = 16;
  private static final long ALLOCATOR = 24;

  private final CFunctions c;
  private final MemorySegment array;

  /**
   * @param arena as long as which the structure lives, not the bytes
   */
  SerializedBytes(CFunctions c, MemorySegment allocator, Arena arena) {
    this.c = c;
    array = arena.allocate(SIZE, Long.BYTES);
    MemorySegment.copy(allocator, 0, array, ALLOCATOR, allocator.byteSize());
  }

  /** What functions of C are given. */
  MemorySegment array() {
    return array;
  }

  private MemorySegment content(long length) {
    return CFunctions.content(array, 0, length);
  }

  void put(byte[] bytes) {
    if (array.get(ValueLayout.JAVA_LONG, CAPACITY) < bytes.length)
      c.check("rcutils_uint8_array_resize", array, (long) bytes.length);
    MemorySegment.copy(bytes, 0, content(bytes.length), ValueLayout.JAVA_BYTE, 0, bytes.length);
    array.set(ValueLayout.JAVA_LONG, LENGTH, bytes.length);
  }

  byte[] get() {
    long length = array.get(ValueLayout.JAVA_LONG, LENGTH);
    return length == 0 ? new byte[0] : content(length).toArray(ValueLayout.JAVA_BYTE);
  }

  @Override
  public void close() {
    c.number("rcutils_uint8_array_fini", array);
  }
}

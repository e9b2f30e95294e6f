package org.urbi.bridge;

import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import urbi.wire.ByteText;

/**
 * Memory that C++ code reads and writes too, by its address; numbers in the machine's byte order.
 */
final class RawMemory {
  @SuppressWarnings("restricted") // C++ says where it is, and nobody else knows how large.
  private static final MemorySegment ALL = MemorySegment.NULL.reinterpret(Long.MAX_VALUE);

  private RawMemory() {}

  static byte getByte(long address) {
    return ALL.get(ValueLayout.JAVA_BYTE, address);
  }

  static int getInt(long address) {
    return ALL.get(ValueLayout.JAVA_INT_UNALIGNED, address);
  }

  static long getLong(long address) {
    return ALL.get(ValueLayout.JAVA_LONG_UNALIGNED, address);
  }

  static double getDouble(long address) {
    return ALL.get(ValueLayout.JAVA_DOUBLE_UNALIGNED, address);
  }

  static byte[] getBytes(long address, int length) {
    byte[] bytes = new byte[length];
    MemorySegment.copy(ALL, ValueLayout.JAVA_BYTE, address, bytes, 0, length);
    return bytes;
  }

  static String getText(long address, int length) {
    return ByteText.decode(getBytes(address, length));
  }

  static void putByte(long address, byte value) {
    ALL.set(ValueLayout.JAVA_BYTE, address, value);
  }

  static void putInt(long address, int value) {
    ALL.set(ValueLayout.JAVA_INT_UNALIGNED, address, value);
  }

  static void putLong(long address, long value) {
    ALL.set(ValueLayout.JAVA_LONG_UNALIGNED, address, value);
  }

  static void putDouble(long address, double value) {
    ALL.set(ValueLayout.JAVA_DOUBLE_UNALIGNED, address, value);
  }

  static void putBytes(long address, byte[] bytes, int from, int length) {
    MemorySegment.copy(bytes, from, ALL, ValueLayout.JAVA_BYTE, address, length);
  }

  static void move(long from, long to, long length) {
    MemorySegment.copy(ALL, from, ALL, to, length);
  }
}

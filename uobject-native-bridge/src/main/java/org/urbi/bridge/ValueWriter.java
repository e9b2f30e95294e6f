package org.urbi.bridge;

import com.sun.jna.Native;
import urbi.UBinary;
import urbi.UValue;
import urbi.wire.ByteText;
import urbi.wire.ValueEncoder;

/** Writes texts and values for C++ code, see {@code urbi/detail/wire.hh}. */
final class ValueWriter extends ValueEncoder {
  /** A binary of which only the address is written: the kind that no other process understands. */
  static final int POINTER = 7;

  private final long given;
  private final long givenCapacity;
  private long begin;
  private long capacity;
  private long length;

  /**
   * @param buffer where to write; as soon as it is too small, memory is allocated
   */
  ValueWriter(long buffer, long capacity) {
    this.given = buffer;
    this.givenCapacity = capacity;
    this.begin = buffer;
    this.capacity = capacity;
  }

  /** Where what was written is. */
  long address() {
    return begin;
  }

  long length() {
    return length;
  }

  /** Forgets what was written. */
  void restart() {
    length = 0;
    abandonValue();
  }

  /** Frees what was allocated. */
  void release() {
    if (begin != given) {
      Native.free(begin);
      begin = given;
      capacity = givenCapacity;
    }
  }

  private long room(long bytes) {
    long wanted = length + bytes;
    if (wanted > capacity) {
      grow(Math.max(wanted, 2 * capacity));
    }
    long at = begin + length;
    length = wanted;
    return at;
  }

  private void grow(long bytes) {
    long bigger = Native.malloc(bytes);
    if (bigger == 0) {
      throw new OutOfMemoryError("no memory for " + bytes + " bytes");
    }
    RawMemory.move(begin, bigger, length);
    release();
    begin = bigger;
    capacity = bytes;
  }

  @Override
  protected void putByte(int value) {
    RawMemory.putByte(room(1), (byte) value);
  }

  @Override
  protected void putInt(int value) {
    RawMemory.putInt(room(Integer.BYTES), value);
  }

  @Override
  protected void putLong(long value) {
    RawMemory.putLong(room(Long.BYTES), value);
  }

  @Override
  protected void putBytes(byte[] value, int from, int size) {
    RawMemory.putBytes(room(size), value, from, size);
  }

  @Override
  protected void putNumber(double value) {
    long at = room(1 + Double.BYTES);
    RawMemory.putByte(at, (byte) DOUBLE);
    RawMemory.putDouble(at + 1, value);
  }

  @Override
  protected void putDataSize(int size) {
    putLong(size);
  }

  @Override
  protected void putBinary(UBinary binary) {
    SharedBinary shared = SharedBinary.of(binary);
    if (shared == null) {
      super.putBinary(binary);
      return;
    }
    byte[] header = shared.header().bytes();
    putByte(POINTER);
    putInt(header.length);
    putBytes(header, 0, header.length);
    putLong(binary.getSize());
    putLong(shared.address());
  }

  void rawDouble(double value) {
    RawMemory.putDouble(room(Double.BYTES), value);
  }

  /** Writes the text of an error: its bytes alone, without what values have before them. */
  void plain(String text) {
    byte[] utf8 = ByteText.encode(text);
    putBytes(utf8, 0, utf8.length);
  }

  void text(String text) {
    putText(text);
  }

  void value(UValue value) {
    putValue(value);
  }
}

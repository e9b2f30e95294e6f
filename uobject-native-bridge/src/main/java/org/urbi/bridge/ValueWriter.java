package org.urbi.bridge;

import com.sun.jna.Native;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import urbi.UBinary;
import urbi.UDataType;
import urbi.UValue;

/** Writes texts and values for C++ code, see {@code urbi/detail/wire.hh}. */
final class ValueWriter {
  static final byte MARK_VOID = 0;
  static final byte MARK_NUMBER = 1;
  static final byte MARK_STRING = 2;
  static final byte MARK_LIST = 3;
  static final byte MARK_DICTIONARY = 4;
  static final byte MARK_BINARY = 5;
  static final byte MARK_SLOTNAME = 6;
  static final byte MARK_POINTER = 7;

  private final long given;
  private long begin;
  private long capacity;
  private long length;

  /**
   * @param buffer where to write; as soon as it is too small, memory is allocated
   */
  ValueWriter(long buffer, long capacity) {
    this.given = buffer;
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
  }

  /** Frees what was allocated. */
  void release() {
    if (begin != given) {
      Native.free(begin);
      begin = given;
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

  void rawLong(long value) {
    RawMemory.putLong(room(Long.BYTES), value);
  }

  void rawDouble(double value) {
    RawMemory.putDouble(room(Double.BYTES), value);
  }

  private void bytes(byte[] bytes) {
    RawMemory.putBytes(room(bytes.length), bytes);
  }

  private void mark(byte mark) {
    RawMemory.putByte(room(1), mark);
  }

  private void count(int number) {
    RawMemory.putInt(room(Integer.BYTES), number);
  }

  /** A text that is no value: of an error. */
  void plain(String text) {
    bytes(text.getBytes(StandardCharsets.UTF_8));
  }

  void text(String text) {
    text(text.getBytes(StandardCharsets.UTF_8));
  }

  private void text(byte... bytes) {
    count(bytes.length);
    bytes(bytes);
  }

  void value(UValue value) {
    switch (value.getType()) {
      case DATA_VOID -> mark(MARK_VOID);
      case DATA_DOUBLE -> {
        long at = room(1 + Double.BYTES);
        RawMemory.putByte(at, MARK_NUMBER);
        RawMemory.putDouble(at + 1, value.doubleValue());
      }
      case DATA_STRING, DATA_SLOTNAME -> {
        mark(value.getType() == UDataType.DATA_STRING ? MARK_STRING : MARK_SLOTNAME);
        text(value.stringValue());
      }
      case DATA_LIST -> {
        mark(MARK_LIST);
        count(value.ulistValue().size());
        value.ulistValue().forEach(this::value);
      }
      case DATA_DICTIONARY -> {
        mark(MARK_DICTIONARY);
        count(value.udictionaryValue().size());
        for (Map.Entry<String, UValue> entry : value.udictionaryValue().entrySet()) {
          text(entry.getKey());
          value(entry.getValue());
        }
      }
      case DATA_BINARY -> binary(value.ubinaryValue());
    }
  }

  private void binary(UBinary binary) {
    SharedBinary shared = SharedBinary.of(binary);
    if (shared != null) {
      mark(MARK_POINTER);
      text(shared.header().bytes());
      rawLong(binary.getSize());
      rawLong(shared.address());
      return;
    }
    mark(MARK_BINARY);
    text(binary.getMessage());
    rawLong(binary.getSize());
    bytes(binary.getData());
  }
}

package org.urbi.bridge;

import urbi.UBinary;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** Reads texts and values that C++ code has written, see {@code urbi/detail/wire.hh}. */
final class ValueReader {
  private long at;
  private final long end;

  ValueReader(long begin, long length) {
    this.at = begin;
    this.end = begin + length;
  }

  boolean ended() {
    return at >= end;
  }

  private long take(long bytes) {
    if (bytes < 0 || end - at < bytes) {
      throw new IllegalStateException("truncated value");
    }
    long start = at;
    at += bytes;
    return start;
  }

  long rawLong() {
    return RawMemory.getLong(take(Long.BYTES));
  }

  double rawDouble() {
    return RawMemory.getDouble(take(Double.BYTES));
  }

  private int count() {
    return RawMemory.getInt(take(Integer.BYTES));
  }

  String text() {
    int length = count();
    return RawMemory.getText(take(length), length);
  }

  /**
   * The binary that is next, if only its address was written; null otherwise.
   *
   * @param before the header of the one before
   */
  SharedBinary shared(SharedHeader before) {
    if (ended() || RawMemory.getByte(at) != ValueWriter.MARK_POINTER) {
      return null;
    }
    take(1);
    SharedHeader header = header(before);
    int size = Math.toIntExact(rawLong());
    return new SharedBinary(header, rawLong(), size);
  }

  private SharedHeader header(SharedHeader before) {
    int length = count();
    long start = take(length);
    return before.isAt(start, length)
        ? before
        : new SharedHeader(RawMemory.getBytes(start, length), RawMemory.getText(start, length));
  }

  UValue value() {
    byte mark = RawMemory.getByte(take(1));
    return switch (mark) {
      case ValueWriter.MARK_VOID -> new UValue();
      case ValueWriter.MARK_NUMBER -> new UValue(rawDouble());
      case ValueWriter.MARK_STRING -> new UValue(text());
      case ValueWriter.MARK_SLOTNAME -> UValue.slotName(text());
      case ValueWriter.MARK_LIST -> {
        UList list = new UList();
        for (int left = count(); left > 0; left--) {
          list.add(value());
        }
        yield new UValue(list);
      }
      case ValueWriter.MARK_DICTIONARY -> {
        UDictionary dictionary = new UDictionary();
        for (int left = count(); left > 0; left--) {
          String name = text();
          dictionary.put(name, value());
        }
        yield new UValue(dictionary);
      }
      case ValueWriter.MARK_BINARY -> {
        String header = text();
        int size = Math.toIntExact(rawLong());
        yield new UValue(new UBinary(header, RawMemory.getBytes(take(size), size)));
      }
      case ValueWriter.MARK_POINTER -> {
        String header = text();
        int size = Math.toIntExact(rawLong());
        yield new UValue(new UBinary(header, RawMemory.getBytes(rawLong(), size)));
      }
      default -> throw new IllegalStateException("malformed value");
    };
  }
}

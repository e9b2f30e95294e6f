package org.urbi.bridge;

import org.jspecify.annotations.Nullable;
import urbi.UBinary;
import urbi.UValue;
import urbi.wire.ValueDecoder;
import urbi.wire.WireException;

/** Reads texts and values that C++ code has written, see {@code urbi/detail/wire.hh}. */
final class ValueReader extends ValueDecoder {
  private long at;
  private final long end;

  ValueReader(long begin, long length) {
    this.at = begin;
    this.end = begin + length;
  }

  boolean ended() {
    return at >= end;
  }

  @Override
  protected void require(long bytes) {
    if (bytes < 0 || end - at < bytes) {
      throw new WireException("a value is cut off");
    }
  }

  private long take(long bytes) {
    require(bytes);
    long start = at;
    at += bytes;
    return start;
  }

  long rawLong() {
    return RawMemory.getLong(take(Long.BYTES));
  }

  /** The number that is next, which stays. */
  long peekLong() {
    long start = at;
    long number = rawLong();
    at = start;
    return number;
  }

  double rawDouble() {
    return RawMemory.getDouble(take(Double.BYTES));
  }

  @Override
  protected int takeByte() {
    return RawMemory.getByte(take(1));
  }

  @Override
  protected int takeInt() {
    return RawMemory.getInt(take(Integer.BYTES));
  }

  @Override
  protected long takeLong() {
    return rawLong();
  }

  @Override
  protected byte[] takeBytes(int length) {
    return RawMemory.getBytes(take(length), length);
  }

  @Override
  protected String takeText(int length) {
    return RawMemory.getText(take(length), length);
  }

  @Override
  protected int takeDataSize() {
    return Math.toIntExact(rawLong());
  }

  @Override
  protected UValue takeOther(int kind) {
    if (kind != ValueWriter.POINTER) {
      return super.takeOther(kind);
    }
    String header = takeText();
    int size = takeDataSize();
    return new UValue(new UBinary(header, RawMemory.getBytes(rawLong(), size)));
  }

  String text() {
    return takeText();
  }

  /**
   * The binary that is next, if only its address was written; null otherwise.
   *
   * @param before the header of the one before
   */
  @Nullable SharedBinary shared(HeaderCache before) {
    if (ended() || RawMemory.getByte(at) != ValueWriter.POINTER) {
      return null;
    }
    take(1);
    HeaderCache header = header(before);
    int size = Math.toIntExact(rawLong());
    return new SharedBinary(header, rawLong(), size);
  }

  private HeaderCache header(HeaderCache before) {
    int length = takeInt();
    long start = take(length);
    return before.isAt(start, length)
        ? before
        : new HeaderCache(RawMemory.getBytes(start, length), RawMemory.getText(start, length));
  }

  UValue value() {
    return takeValue();
  }
}

package urbi.wire;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;
import urbi.UValue;

/** Writes frames one after the other into a growing array. */
public final class WireOutput extends ValueEncoder {
  private static final VarHandle INT =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.BIG_ENDIAN);
  private static final VarHandle LONG =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);
  private byte[] bytes;
  private int size;
  private int start;

  public WireOutput(int capacity) {
    bytes = new byte[capacity];
  }

  private void ensure(int more) {
    if (bytes.length - size < more) {
      bytes = Arrays.copyOf(bytes, Math.max(Math.addExact(size, more), bytes.length * 2));
    }
  }

  /** Begins a frame. */
  public WireOutput begin(int type) {
    start = size;
    size(0);
    return octet(type);
  }

  /** Ends the frame. */
  public WireOutput end() {
    int length = size - start - 4;
    if (length > Protocol.MAX_FRAME) {
      size = start;
      throw new WireException("a value is too large: " + length + " bytes");
    }
    INT.set(bytes, start, length);
    return this;
  }

  /** A copy of what is between the length and the end of the only frame. */
  public byte[] inside() {
    return Arrays.copyOfRange(bytes, start + 4, size);
  }

  /** Forgets the frame that has been begun. */
  public void abandon() {
    size = start;
    abandonValue();
  }

  @Override
  protected void putByte(int value) {
    ensure(1);
    bytes[size++] = (byte) value;
  }

  @Override
  protected void putInt(int value) {
    ensure(4);
    INT.set(bytes, size, value);
    size += 4;
  }

  @Override
  protected void putLong(long value) {
    ensure(8);
    LONG.set(bytes, size, value);
    size += 8;
  }

  @Override
  protected void putBytes(byte[] value, int from, int length) {
    ensure(length);
    System.arraycopy(value, from, bytes, size, length);
    size += length;
  }

  public WireOutput octet(int value) {
    putByte(value);
    return this;
  }

  public WireOutput size(int value) {
    putInt(value);
    return this;
  }

  public WireOutput number(long value) {
    putLong(value);
    return this;
  }

  public WireOutput bytes(byte[] value, int from, int length) {
    putBytes(value, from, length);
    return this;
  }

  public WireOutput text(String value) {
    putText(value);
    return this;
  }

  public WireOutput values(UValue... values) {
    size(values.length);
    for (UValue value : values) {
      value(value);
    }
    return this;
  }

  public WireOutput value(UValue value) {
    putValue(value);
    return this;
  }

  public int length() {
    return size;
  }

  /** The array itself, of which {@link #length} bytes are written. */
  public byte[] array() {
    return bytes;
  }

  /** A copy of what is written. */
  public byte[] toBytes() {
    return Arrays.copyOf(bytes, size);
  }

  /** Starts again, and gives back what a large value has needed. */
  public void reset() {
    size = 0;
    abandonValue();
    if (bytes.length > 1 << 20) {
      bytes = new byte[1 << 16];
    }
  }
}

package urbi.wire;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import urbi.UBinary;
import urbi.UValue;

/** Writes frames one after the other into a growing array. */
public final class WireOutput {
  private static final VarHandle INT =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.BIG_ENDIAN);
  private static final VarHandle LONG =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);
  private static final int DEEPEST = 500;

  static final int VOID = 0;
  static final int DOUBLE = 1;
  static final int STRING = 2;
  static final int LIST = 3;
  static final int DICTIONARY = 4;
  static final int BINARY = 5;
  static final int SLOT_NAME = 6;

  private byte[] bytes;
  private int size;
  private int start;
  private int depth;

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
    if (length > Protocol.LONGEST_FRAME) {
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
    depth = 0;
  }

  public WireOutput octet(int value) {
    ensure(1);
    bytes[size++] = (byte) value;
    return this;
  }

  public WireOutput size(int value) {
    ensure(4);
    INT.set(bytes, size, value);
    size += 4;
    return this;
  }

  public WireOutput number(long value) {
    ensure(8);
    LONG.set(bytes, size, value);
    size += 8;
    return this;
  }

  public WireOutput bytes(byte[] value, int from, int length) {
    ensure(length);
    System.arraycopy(value, from, bytes, size, length);
    size += length;
    return this;
  }

  public WireOutput text(String value) {
    byte[] utf8 = value.getBytes(StandardCharsets.UTF_8);
    return size(utf8.length).bytes(utf8, 0, utf8.length);
  }

  public WireOutput values(UValue... values) {
    size(values.length);
    for (UValue value : values) {
      value(value);
    }
    return this;
  }

  public WireOutput value(UValue value) {
    if (++depth > DEEPEST) {
      throw new WireException("a value is nested too deeply");
    }
    switch (value.getType()) {
      case DATA_VOID -> octet(VOID);
      case DATA_DOUBLE -> octet(DOUBLE).number(Double.doubleToRawLongBits(value.doubleValue()));
      case DATA_STRING -> octet(STRING).text(value.stringValue());
      case DATA_SLOTNAME -> octet(SLOT_NAME).text(value.stringValue());
      case DATA_LIST -> {
        octet(LIST).size(value.ulistValue().size());
        value.ulistValue().forEach(this::value);
      }
      case DATA_DICTIONARY -> {
        octet(DICTIONARY).size(value.udictionaryValue().size());
        for (Map.Entry<String, UValue> entry : value.udictionaryValue().entrySet()) {
          text(entry.getKey()).value(entry.getValue());
        }
      }
      case DATA_BINARY -> {
        UBinary binary = value.ubinaryValue();
        octet(BINARY).text(binary.getMessage()).size(binary.getSize());
        bytes(binary.getData(), 0, binary.getSize());
      }
    }
    depth--;
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
    depth = 0;
    if (bytes.length > 1 << 20) {
      bytes = new byte[1 << 16];
    }
  }
}

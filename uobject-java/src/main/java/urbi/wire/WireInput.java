package urbi.wire;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import urbi.UBinary;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** Reads what {@link WireOutput} has written: the inside of one frame. */
public final class WireInput {
  private static final VarHandle INT =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.BIG_ENDIAN);
  private static final VarHandle LONG =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);
  private static final int DEEPEST = 500;

  private final byte[] bytes;
  private final int end;
  private int at;
  private int depth;

  public WireInput(byte[] bytes, int from, int end) {
    this.bytes = bytes;
    this.at = from;
    this.end = end;
  }

  private void require(long more) {
    if (more < 0 || end - at < more) {
      throw new WireException("a frame is shorter than what it should hold");
    }
  }

  /** The size of a frame, which the array has at that place. */
  public static int frameLength(byte[] bytes, int at) {
    return (int) INT.get(bytes, at);
  }

  public int octet() {
    require(1);
    return bytes[at++] & 0xff;
  }

  public int size() {
    require(4);
    int value = (int) INT.get(bytes, at);
    at += 4;
    return value;
  }

  public long number() {
    require(8);
    long value = (long) LONG.get(bytes, at);
    at += 8;
    return value;
  }

  public String text() {
    int length = size();
    require(length);
    String text = new String(bytes, at, length, StandardCharsets.UTF_8);
    at += length;
    return text;
  }

  /** The next so many octets. */
  public byte[] bytes(int length) {
    require(length);
    byte[] copy = Arrays.copyOfRange(bytes, at, at + length);
    at += length;
    return copy;
  }

  /** Whether anything is left. */
  public boolean hasMore() {
    return at < end;
  }

  /** All that is left. */
  public byte[] rest() {
    byte[] rest = Arrays.copyOfRange(bytes, at, end);
    at = end;
    return rest;
  }

  public UValue[] values() {
    int count = size();
    require(count);
    UValue[] values = new UValue[count];
    for (int i = 0; i < count; i++) {
      values[i] = value();
    }
    return values;
  }

  public UValue value() {
    if (++depth > DEEPEST) {
      throw new WireException("a value is nested too deeply");
    }
    int kind = octet();
    UValue value =
        switch (kind) {
          case WireOutput.VOID -> new UValue();
          case WireOutput.DOUBLE -> new UValue(Double.longBitsToDouble(number()));
          case WireOutput.STRING -> new UValue(text());
          case WireOutput.SLOT_NAME -> UValue.slotName(text());
          case WireOutput.LIST -> list();
          case WireOutput.DICTIONARY -> dictionary();
          case WireOutput.BINARY -> binary();
          default -> throw new WireException("no kind of value: " + kind);
        };
    depth--;
    return value;
  }

  private UValue list() {
    int count = size();
    require(count);
    UList list = new UList();
    for (int i = 0; i < count; i++) {
      list.add(value());
    }
    return new UValue(list);
  }

  private UValue dictionary() {
    int count = size();
    require(count);
    UDictionary dictionary = new UDictionary();
    for (int i = 0; i < count; i++) {
      dictionary.put(text(), value());
    }
    return new UValue(dictionary);
  }

  private UValue binary() {
    String header = text();
    int length = size();
    require(length);
    byte[] data = Arrays.copyOfRange(bytes, at, at + length);
    at += length;
    try {
      return new UValue(new UBinary(header, data));
    } catch (IllegalArgumentException e) {
      throw new WireException(e.getMessage());
    }
  }
}

package urbi.wire;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;
import urbi.UValue;

/** Reads the contents of one frame, as {@link WireOutput} has written them. */
public final class WireInput extends ValueDecoder {
  private static final VarHandle INT =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.BIG_ENDIAN);
  private static final VarHandle LONG =
      MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);

  private final byte[] bytes;
  private final int end;
  private int at;

  public WireInput(byte[] bytes, int from, int end) {
    this.bytes = bytes;
    this.at = from;
    this.end = end;
  }

  @Override
  protected void require(long more) {
    if (more < 0 || end - at < more) {
      throw new WireException("a frame is shorter than what it should hold");
    }
  }

  /** The size of a frame, which the array has at that place. */
  public static int frameLength(byte[] bytes, int at) {
    return (int) INT.get(bytes, at);
  }

  @Override
  protected int takeByte() {
    require(1);
    return bytes[at++] & 0xff;
  }

  @Override
  protected int takeInt() {
    require(4);
    int value = (int) INT.get(bytes, at);
    at += 4;
    return value;
  }

  @Override
  protected long takeLong() {
    require(8);
    long value = (long) LONG.get(bytes, at);
    at += 8;
    return value;
  }

  @Override
  protected byte[] takeBytes(int length) {
    require(length);
    byte[] taken = Arrays.copyOfRange(bytes, at, at + length);
    at += length;
    return taken;
  }

  @Override
  protected String takeText(int length) {
    require(length);
    String text = ByteText.decode(bytes, at, length);
    at += length;
    return text;
  }

  public int octet() {
    return takeByte();
  }

  public int size() {
    return takeInt();
  }

  public long number() {
    return takeLong();
  }

  public String text() {
    return takeText();
  }

  /** The next so many octets. */
  public byte[] bytes(int length) {
    return takeBytes(length);
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
    return takeValue();
  }
}

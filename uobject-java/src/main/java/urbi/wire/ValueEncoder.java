package urbi.wire;

import java.util.Map;
import urbi.UBinary;
import urbi.UValue;

/**
 * Encodes values as bytes: a byte for the kind, then a number, a text after its length, or the
 * elements after their count. The subclass decides where the bytes go, and in which byte order.
 */
public abstract class ValueEncoder {
  /** The kinds of values, by the byte that they start with. */
  public static final int VOID = 0;

  public static final int DOUBLE = 1;
  public static final int STRING = 2;
  public static final int LIST = 3;
  public static final int DICTIONARY = 4;
  public static final int BINARY = 5;
  public static final int SLOT_NAME = 6;

  /** No value has more others in one another. */
  static final int DEEPEST = 500;

  private int depth;

  protected abstract void putByte(int value);

  protected abstract void putInt(int value);

  protected abstract void putLong(long value);

  protected abstract void putBytes(byte[] value, int from, int length);

  /** A number with its kind before it: most values are numbers. */
  protected void putNumber(double value) {
    putByte(DOUBLE);
    putLong(Double.doubleToRawLongBits(value));
  }

  /** How many bytes of data a binary has. */
  protected void putDataSize(int size) {
    putInt(size);
  }

  protected final void putText(String value) {
    byte[] utf8 = ByteText.encode(value);
    putInt(utf8.length);
    putBytes(utf8, 0, utf8.length);
  }

  /** A binary with its kind before it. */
  protected void putBinary(UBinary binary) {
    putByte(BINARY);
    putText(binary.getMessage());
    putDataSize(binary.getSize());
    putBytes(binary.getData(), 0, binary.getSize());
  }

  /**
   * Writes a value.
   *
   * @throws WireException if it is nested too deeply
   */
  protected final void putValue(UValue value) {
    if (++depth > DEEPEST) {
      throw new WireException("a value is nested too deeply");
    }
    switch (value.getType()) {
      case DATA_VOID -> putByte(VOID);
      case DATA_DOUBLE -> putNumber(value.doubleValue());
      case DATA_STRING -> {
        putByte(STRING);
        putText(value.stringValue());
      }
      case DATA_SLOTNAME -> {
        putByte(SLOT_NAME);
        putText(value.stringValue());
      }
      case DATA_LIST -> {
        putByte(LIST);
        putInt(value.ulistValue().size());
        value.ulistValue().forEach(this::putValue);
      }
      case DATA_DICTIONARY -> {
        putByte(DICTIONARY);
        putInt(value.udictionaryValue().size());
        for (Map.Entry<String, UValue> entry : value.udictionaryValue().entrySet()) {
          putText(entry.getKey());
          putValue(entry.getValue());
        }
      }
      case DATA_BINARY -> putBinary(value.ubinaryValue());
    }
    depth--;
  }

  /** What was written in part is forgotten. */
  protected final void abandonValue() {
    depth = 0;
  }
}

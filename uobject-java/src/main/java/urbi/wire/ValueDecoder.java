package urbi.wire;

import urbi.UBinary;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** Decodes values that a {@link ValueEncoder} has written. */
public abstract class ValueDecoder {
  private int depth;

  /**
   * Checks that there are so many bytes.
   *
   * @throws WireException if there are fewer
   */
  protected abstract void require(long bytes);

  protected abstract int takeByte();

  protected abstract int takeInt();

  protected abstract long takeLong();

  protected abstract byte[] takeBytes(int length);

  /** Text of so many bytes in UTF-8. */
  protected abstract String takeText(int length);

  /** How many bytes of data a binary has. */
  protected int takeDataSize() {
    return takeInt();
  }

  /** Reads a value of an unusual kind, after the byte of the kind. */
  protected UValue takeOther(int kind) {
    throw new WireException("no kind of value: " + kind);
  }

  protected final String takeText() {
    return takeText(takeInt());
  }

  /**
   * Reads a value.
   *
   * @throws WireException if there is none, or it is nested too deeply
   */
  protected final UValue takeValue() {
    if (++depth > ValueEncoder.DEEPEST) {
      throw new WireException("a value is nested too deeply");
    }
    int kind = takeByte();
    UValue value =
        switch (kind) {
          case ValueEncoder.VOID -> new UValue();
          case ValueEncoder.DOUBLE -> new UValue(Double.longBitsToDouble(takeLong()));
          case ValueEncoder.STRING -> new UValue(takeText());
          case ValueEncoder.SLOT_NAME -> UValue.slotName(takeText());
          case ValueEncoder.LIST -> list();
          case ValueEncoder.DICTIONARY -> dictionary();
          case ValueEncoder.BINARY -> binary();
          default -> takeOther(kind);
        };
    depth--;
    return value;
  }

  private int count() {
    int count = takeInt();
    require(count);
    return count;
  }

  private UValue list() {
    UList list = new UList();
    for (int left = count(); left > 0; left--) {
      list.add(takeValue());
    }
    return new UValue(list);
  }

  private UValue dictionary() {
    UDictionary dictionary = new UDictionary();
    for (int left = count(); left > 0; left--) {
      String name = takeText();
      dictionary.put(name, takeValue());
    }
    return new UValue(dictionary);
  }

  private UValue binary() {
    String header = takeText();
    byte[] data = takeBytes(takeDataSize());
    try {
      return new UValue(new UBinary(header, data));
    } catch (IllegalArgumentException e) {
      throw new WireException(e.getMessage());
    }
  }
}

package urbi;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A value of any kind that Urbi and Java exchange (manual, "The UObject Java API").
 *
 * <p>Getters convert where nothing is lost in meaning, a number to text or text that is a number to
 * one, and throw {@link UCastException} otherwise. A value may be changed by its setters; who
 * shares one between threads does not call them.
 */
public final class UValue {
  private static final int MAX_BRIEF = 60;

  private UDataType type = UDataType.DATA_VOID;
  private double number;
  private @Nullable Object content;

  /** Nothing. */
  public UValue() {
    clear();
  }

  /** A copy of a value, which shares its list, dictionary or binary. */
  public UValue(UValue other) {
    set(other);
  }

  public UValue(double value) {
    setValue(value);
  }

  public UValue(long value) {
    setValue(value);
  }

  /** 1 for true, 0 for false. */
  public UValue(boolean value) {
    setValue(value);
  }

  /** A string of one character. */
  public UValue(char value) {
    setValue(String.valueOf(value));
  }

  public UValue(String value) {
    setValue(value);
  }

  public UValue(UBinary value) {
    setValue(value);
  }

  public UValue(UImage value) {
    setValue(value);
  }

  public UValue(USound value) {
    setValue(value);
  }

  public UValue(UList value) {
    setValue(value);
  }

  public UValue(UDictionary value) {
    setValue(value);
  }

  /** The value that stands for a Java object, see {@link UCast#toUValue}. */
  public static UValue of(Object value) {
    return UCast.toUValue(value);
  }

  /** The name of a slot, as {@code camera.val}, or of an object. */
  public static UValue slotName(String name) {
    return new UValue().hold(UDataType.DATA_SLOTNAME, name);
  }

  /**
   * Reads an urbiscript literal: number, duration, string, list, dictionary, binary, or a name.
   *
   * @throws UParseException if the text is none, or more than that
   */
  public static UValue parse(String literal) {
    return new UValueReader(literal).whole();
  }

  /**
   * Reads an urbiscript literal as it comes from a server.
   *
   * @throws UParseException if the bytes are not a literal, or go on behind it
   */
  public static UValue parse(byte[] literal) {
    return new UValueReader(literal, 0, literal.length).whole();
  }

  private UValue hold(UDataType kind, Object value) {
    content = Objects.requireNonNull(value, "value");
    type = kind;
    return this;
  }

  private Object held() {
    return Objects.requireNonNull(content, "only nothing and a number hold no object");
  }

  /** Makes it nothing. */
  public void clear() {
    type = UDataType.DATA_VOID;
    content = null;
  }

  /** Makes it the same as another; lists, dictionaries and binaries are shared with it. */
  public UValue set(UValue other) {
    type = other.type;
    number = other.number;
    content = other.content;
    return this;
  }

  public void setValue(UValue other) {
    set(other);
  }

  public void setValue(double value) {
    type = UDataType.DATA_DOUBLE;
    number = value;
    content = null;
  }

  public void setValue(long value) {
    setValue((double) value);
  }

  public void setValue(boolean value) {
    setValue(value ? 1.0 : 0.0);
  }

  public void setValue(String value) {
    hold(UDataType.DATA_STRING, value);
  }

  public void setValue(UBinary value) {
    hold(UDataType.DATA_BINARY, value);
  }

  public void setValue(UImage value) {
    setValue(new UBinary(value));
  }

  public void setValue(USound value) {
    setValue(new UBinary(value));
  }

  public void setValue(UList value) {
    hold(UDataType.DATA_LIST, value);
  }

  public void setValue(UDictionary value) {
    hold(UDataType.DATA_DICTIONARY, value);
  }

  /** What it holds. */
  public UDataType getType() {
    return type;
  }

  /** The kind of value in a word, for people. */
  public String format_string() {
    return switch (type) {
      case DATA_BINARY -> "binary";
      case DATA_DICTIONARY -> "dictionary";
      case DATA_DOUBLE -> "double";
      case DATA_LIST -> "list";
      case DATA_STRING -> "string";
      case DATA_SLOTNAME -> "slotname";
      case DATA_VOID -> "void";
    };
  }

  /** Whether it is nothing. */
  public boolean isVoid() {
    return type == UDataType.DATA_VOID;
  }

  /** The number, or the one that the string is. */
  public double doubleValue() {
    if (type == UDataType.DATA_DOUBLE) {
      return number;
    }
    if (type == UDataType.DATA_STRING) {
      try {
        UValue read = parse((String) held());
        if (read.type == UDataType.DATA_DOUBLE) {
          return read.number;
        }
      } catch (UParseException e) {
        throw UCastException.to("double", this);
      }
    }
    throw UCastException.to("double", this);
  }

  public float floatValue() {
    return (float) doubleValue();
  }

  /** The number without its decimals; where it is too large, its lowest 32 bits. */
  public int intValue() {
    return (int) longValue();
  }

  /** The number without its decimals; the nearest one where it is too large. */
  public long longValue() {
    return (long) doubleValue();
  }

  /** Whether the number is not 0. */
  public boolean booleanValue() {
    return doubleValue() != 0;
  }

  /** The string, the number as text, or the name of the slot. */
  public String stringValue() {
    return switch (type) {
      case DATA_STRING, DATA_SLOTNAME -> (String) held();
      case DATA_DOUBLE -> UValueWriter.number(number);
      default -> throw UCastException.to("String", this);
    };
  }

  /** The binary itself; changes of it are changes of this value. */
  public UBinary ubinaryValue() {
    if (type != UDataType.DATA_BINARY) {
      throw UCastException.to("UBinary", this);
    }
    return (UBinary) held();
  }

  /** The image in the binary; the data are shared. */
  public UImage uimageValue() {
    if (type != UDataType.DATA_BINARY) {
      throw UCastException.to("UImage", this);
    }
    return ((UBinary) held()).uimageValue();
  }

  /** The sound in the binary; the data are shared. */
  public USound usoundValue() {
    if (type != UDataType.DATA_BINARY) {
      throw UCastException.to("USound", this);
    }
    return ((UBinary) held()).usoundValue();
  }

  /** The list itself; changes of it are changes of this value. */
  public UList ulistValue() {
    if (type != UDataType.DATA_LIST) {
      throw UCastException.to("UList", this);
    }
    return (UList) held();
  }

  /** The dictionary itself; changes of it are changes of this value. */
  public UDictionary udictionaryValue() {
    if (type != UDataType.DATA_DICTIONARY) {
      throw UCastException.to("UDictionary", this);
    }
    return (UDictionary) held();
  }

  /**
   * The value as an instance of a Java type: a primitive, a string, a type of this package, a
   * collection, a record, an enumeration, or what {@link UCast} was told of.
   *
   * @throws UCastException if it is not
   */
  public <T> @Nullable T as(Class<T> target) {
    return UCast.to(this, target);
  }

  /** The literal as a server takes it: text in UTF-8, data of binaries as they are. */
  public byte[] toBytes() {
    return UValueWriter.bytes(this);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof UValue that
        && type == that.type
        && (type == UDataType.DATA_DOUBLE
            ? number == that.number || Double.isNaN(number) && Double.isNaN(that.number)
            : Objects.equals(content, that.content));
  }

  @Override
  public int hashCode() {
    return type == UDataType.DATA_DOUBLE
        ? Double.hashCode(number + 0.0)
        : 31 * type.hashCode() + Objects.hashCode(content);
  }

  /** The value as an urbiscript literal. */
  @Override
  public String toString() {
    return UValueWriter.text(this);
  }

  /** What is shown of it in a message. */
  String brief() {
    if (type == UDataType.DATA_BINARY) {
      UBinary binary = (UBinary) held();
      return ("BIN " + binary.getSize() + " " + binary.getMessage()).strip();
    }
    String text = toString();
    return text.length() <= MAX_BRIEF ? text : text.substring(0, MAX_BRIEF) + "…";
  }
}

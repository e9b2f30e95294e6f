package org.urbi.ros.message;

import urbi.UBinary;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/**
 * Messages as they are before anybody sets anything: zeros, empty strings, lists, what the file
 * says. Bytes are Binaries; times have {@code sec} and {@code nanosec} in both versions of ROS.
 */
public final class Templates {
  /** The keys of a time. */
  public static final String SECONDS = "sec";

  public static final String NANOSECONDS = "nanosec";

  /** Nanoseconds. */
  private static final long SECOND = 1_000_000_000;

  private Templates() {}

  /** A new message of a type. */
  public static UDictionary of(MessageType type) {
    return of(type.definition(), type);
  }

  private static UDictionary of(MessageDefinition definition, MessageType within) {
    UDictionary message = new UDictionary();
    for (Field field : definition.fields()) {
      UValue initial = field.initial();
      message.put(
          field.name(), initial == null ? of(field.type(), within) : initial(field, initial));
    }
    return message;
  }

  private static UValue initial(Field field, UValue value) {
    if (!(field.type() instanceof FieldType.Array array)) {
      return new UValue(value);
    }
    if (!isBytes(array, Dialect.ROS_2)) {
      return new UValue(new UList(value.ulistValue()));
    }
    byte[] bytes = new byte[value.ulistValue().size()];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) value.ulistValue().get(i).intValue();
    }
    return new UValue(new UBinary(bytes));
  }

  private static UValue of(FieldType type, MessageType within) {
    return switch (type) {
      case FieldType.Basic(Primitive primitive) -> primitive.isInstant() ? instant(0, 0) : zero();
      case FieldType.Text text -> new UValue("");
      case FieldType.Nested(TypeName name) -> new UValue(of(within.definition(name), within));
      case FieldType.Array array -> array(array, within);
    };
  }

  private static UValue zero() {
    return new UValue(0.0);
  }

  /** A time by its nanoseconds since 1970. */
  public static UValue time(long nanoseconds) {
    return instant(nanoseconds / SECOND, nanoseconds % SECOND);
  }

  /** The nanoseconds of a time; 0 where one of its keys is missing. */
  public static long nanoseconds(UDictionary time) {
    UValue none = zero();
    return (long) time.getOrDefault(SECONDS, none).doubleValue() * SECOND
        + (long) time.getOrDefault(NANOSECONDS, none).doubleValue();
  }

  /** A time of ROS 1: the same keys as {@code builtin_interfaces/msg/Time} has. */
  public static UValue instant(double seconds, double nanoseconds) {
    UDictionary time = new UDictionary();
    time.put(SECONDS, new UValue(seconds));
    time.put(NANOSECONDS, new UValue(nanoseconds));
    return new UValue(time);
  }

  private static UValue array(FieldType.Array array, MessageType within) {
    int size = array.length() == FieldType.Length.FIXED ? array.size() : 0;
    if (isBytes(array, within.dialect())) {
      return new UValue(new UBinary(new byte[size]));
    }
    UList list = new UList();
    for (int i = 0; i < size; i++) {
      list.add(of(array.element(), within));
    }
    return new UValue(list);
  }

  /** Whether an array is one of bytes without a sign, which are a Binary and not a list. */
  public static boolean isBytes(FieldType.Array array, Dialect dialect) {
    return array.element() instanceof FieldType.Basic(Primitive primitive)
        && switch (primitive) {
          case UINT8, CHAR -> true;
          case BYTE -> dialect == Dialect.ROS_2;
          default -> false;
        };
  }
}

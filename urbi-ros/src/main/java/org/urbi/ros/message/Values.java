package org.urbi.ros.message;

import java.nio.charset.StandardCharsets;
import urbi.UDataType;
import urbi.UValue;

/**
 * Checks whether a value fits the type of a field. The errors do not name the field: the caller
 * knows it, and adds its name.
 */
public final class Values {
  /** From here on not every whole number is a number of urbiscript. */
  private static final double TWO_TO_63 = 0x1p63;

  /** How many bytes UTF-8 takes at most for what is one {@code char}. */
  private static final long MOST_BYTES = 3;

  private Values() {}

  /**
   * The number, checked.
   *
   * @throws ValueException if it is no number, or does not fit
   */
  public static double number(Primitive primitive, UValue value) {
    if (value.getType() != UDataType.DATA_DOUBLE) {
      throw new ValueException("a number expected, not " + shown(value));
    }
    double number = value.doubleValue();
    switch (primitive) {
      case FLOAT64 -> {}
      case FLOAT32 -> {
        if (Double.isFinite(number) && Float.isInfinite((float) number)) {
          throw outOfRange(primitive, value);
        }
      }
      default -> {
        if (number != Math.rint(number) || Double.isInfinite(number)) {
          throw new ValueException("a whole number expected, not " + shown(value));
        }
        // The largest whole numbers of 64 bits are rounded up as numbers of urbiscript.
        if (number < least(primitive) || number > most(primitive)) {
          throw outOfRange(primitive, value);
        }
      }
    }
    return number;
  }

  /** The whole number as bits: one above the largest, which only rounding makes, is the largest. */
  public static long bits(Primitive primitive, double number) {
    if (primitive == Primitive.UINT64 && number >= TWO_TO_63) {
      return number >= 2 * TWO_TO_63 ? -1 : (long) (number - TWO_TO_63) + Long.MIN_VALUE;
    }
    return (long) number;
  }

  private static double least(Primitive primitive) {
    return switch (primitive) {
      case BYTE, INT8 -> Byte.MIN_VALUE;
      case INT16 -> Short.MIN_VALUE;
      case INT32 -> Integer.MIN_VALUE;
      case INT64 -> -TWO_TO_63;
      default -> 0;
    };
  }

  private static double most(Primitive primitive) {
    return switch (primitive) {
      case BOOL -> 1;
      case INT8 -> Byte.MAX_VALUE;
      case BYTE, CHAR, UINT8 -> 0xFF;
      case INT16 -> Short.MAX_VALUE;
      case UINT16 -> 0xFFFF;
      case INT32 -> Integer.MAX_VALUE;
      case UINT32 -> 0xFFFF_FFFFL;
      case INT64 -> TWO_TO_63;
      default -> 2 * TWO_TO_63;
    };
  }

  private static ValueException outOfRange(Primitive primitive, UValue value) {
    return new ValueException(
        shown(value) + " is out of range of " + TypeReader.write(new FieldType.Basic(primitive)));
  }

  /**
   * The string, checked. What limits it is what a peer may have made room for: its bytes in UTF-8,
   * or its units of 16 bits when it is wide.
   *
   * @throws ValueException if it is no string, or is too long
   */
  public static String text(FieldType.Text type, UValue value) {
    if (value.getType() != UDataType.DATA_STRING) {
      throw new ValueException("a string expected, not " + shown(value));
    }
    String text = value.stringValue();
    if (type.limit() == 0 || text.length() * MOST_BYTES <= type.limit()) {
      return text;
    }
    int length = type.wide() ? text.length() : text.getBytes(StandardCharsets.UTF_8).length;
    if (length > type.limit()) {
      throw new ValueException(
          "a string of "
              + type.limit()
              + (type.wide() ? " characters" : " bytes")
              + " at most expected, not of "
              + length);
    }
    return text;
  }

  /**
   * Checks how many elements an array has.
   *
   * @throws ValueException if it has too many, or not as many as it must have
   */
  public static void count(FieldType.Array type, int count) {
    switch (type.length()) {
      case FIXED -> {
        if (count != type.size()) {
          throw new ValueException(type.size() + " elements expected, not " + count);
        }
      }
      case BOUNDED -> {
        if (count > type.size()) {
          throw new ValueException(type.size() + " elements at most expected, not " + count);
        }
      }
      case ANY -> {}
    }
  }

  /** What a value is, in a message. */
  public static String shown(UValue value) {
    return switch (value.getType()) {
      case DATA_VOID -> "nothing";
      case DATA_BINARY -> "a Binary of " + value.ubinaryValue().getSize() + " bytes";
      case DATA_LIST -> "a List of " + value.ulistValue().size() + " elements";
      case DATA_DICTIONARY -> "a Dictionary of " + value.udictionaryValue().size() + " entries";
      default -> {
        String text = value.toString();
        yield text.length() <= 60 ? text : text.substring(0, 60) + "…";
      }
    };
  }
}

package org.urbi.ros.bridge;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.message.Field;
import org.urbi.ros.message.FieldType;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Primitive;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.TypeName;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/**
 * Messages of topics as rosbridge writes them in CBOR (RFC 8949): bytes as such, and arrays of
 * numbers as typed arrays (RFC 8746), which pages get without a conversion.
 */
final class CborMessages {
  // The major types of RFC 8949.
  private static final int WHOLE = 0;
  private static final int NEGATIVE = 1;
  private static final int BYTES = 2;
  private static final int TEXT = 3;
  private static final int LIST = 4;
  private static final int MAP = 5;
  private static final int TAG = 6;

  private static final long SECOND = 1_000_000_000;

  private static final int FALSE = 0xF4;
  private static final int TRUE = 0xF5;
  private static final int NULL = 0xF6;
  private static final int DOUBLE = 0xFB;

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();

  private CborMessages() {}

  /** What tells a client of a message: the operation {@code publish}. */
  static byte[] publication(String topic, UDictionary message, MessageType type) {
    CborMessages writer = begun(topic);
    writer.write(message, type);
    return writer.out.toByteArray();
  }

  /**
   * What tells a client of a message, as its nodes send it: for clients that read that themselves.
   *
   * @param now when it came, in nanoseconds since 1970
   */
  static byte[] raw(String topic, byte[] message, long now) {
    CborMessages writer = begun(topic);
    writer.head(MAP, 3);
    writer.time(now / SECOND, now % SECOND);
    writer.text("bytes");
    writer.bytes(message);
    return writer.out.toByteArray();
  }

  /** The operation {@code publish} up to the message. */
  private static CborMessages begun(String topic) {
    CborMessages writer = new CborMessages();
    writer.head(MAP, 3);
    writer.text("op");
    writer.text("publish");
    writer.text("topic");
    writer.text(topic);
    writer.text("msg");
    return writer;
  }

  private void write(UDictionary message, MessageType type) {
    head(MAP, type.definition().fields().size());
    for (Field field : type.definition().fields()) {
      text(field.name());
      UValue value = message.get(field.name());
      if (value == null) {
        out.write(NULL);
      } else {
        write(value, field.type(), type);
      }
    }
  }

  private void write(UValue value, FieldType type, MessageType within) {
    switch (type) {
      case FieldType.Basic(Primitive primitive) -> write(value, primitive);
      case FieldType.Text text -> text(value.stringValue());
      case FieldType.Nested(TypeName name) -> write(value.udictionaryValue(), within.part(name));
      case FieldType.Array array -> {
        if (value.getType() == UDataType.DATA_BINARY) {
          bytes(value.ubinaryValue().getData());
        } else if (array.element() instanceof FieldType.Basic(Primitive primitive)
            && tag(primitive) > 0) {
          head(TAG, tag(primitive));
          bytes(packed(value.ulistValue(), primitive));
        } else {
          UList list = value.ulistValue();
          head(LIST, list.size());
          for (UValue each : list) {
            write(each, array.element(), within);
          }
        }
      }
    }
  }

  private void write(UValue value, Primitive primitive) {
    switch (primitive) {
      case BOOL -> out.write(value.doubleValue() == 0 ? FALSE : TRUE);
      case FLOAT32, FLOAT64 -> {
        out.write(DOUBLE);
        out.writeBytes(ByteBuffer.allocate(Double.BYTES).putDouble(value.doubleValue()).array());
      }
      case TIME, DURATION -> {
        UDictionary time = value.udictionaryValue();
        head(MAP, 2);
        time(number(time.get(Templates.SECONDS)), number(time.get(Templates.NANOSECONDS)));
      }
      case UINT64 -> head(WHOLE, withoutSign(value.doubleValue()));
      default -> whole((long) value.doubleValue());
    }
  }

  private void time(long seconds, long nanoseconds) {
    text("secs");
    whole(seconds);
    text("nsecs");
    whole(nanoseconds);
  }

  private static long number(@Nullable UValue value) {
    return value == null ? 0 : (long) value.doubleValue();
  }

  /** The tag of an array of such numbers, the lowest byte of each first; 0 if there is none. */
  private static int tag(Primitive primitive) {
    return switch (primitive) {
      case INT8 -> 72;
      case UINT16 -> 69;
      case UINT32 -> 70;
      case UINT64 -> 71;
      case INT16 -> 77;
      case INT32 -> 78;
      case INT64 -> 79;
      case FLOAT32 -> 85;
      case FLOAT64 -> 86;
      default -> 0;
    };
  }

  private static byte[] packed(UList list, Primitive primitive) {
    ByteBuffer packed =
        ByteBuffer.allocate(list.size() * primitive.size()).order(ByteOrder.LITTLE_ENDIAN);
    for (UValue each : list) {
      double number = each.doubleValue();
      switch (primitive) {
        case FLOAT32 -> packed.putFloat((float) number);
        case FLOAT64 -> packed.putDouble(number);
        case INT8 -> packed.put((byte) number);
        case INT16, UINT16 -> packed.putShort((short) (int) number);
        case INT32, UINT32 -> packed.putInt((int) (long) number);
        case UINT64 -> packed.putLong(withoutSign(number));
        default -> packed.putLong((long) number);
      }
    }
    return packed.array();
  }

  /** The 64 bits of a whole number that is not negative. */
  private static long withoutSign(double number) {
    boolean isBeyond = number >= 0x1p63;
    return isBeyond ? (long) (number - 0x1p63) + Long.MIN_VALUE : (long) number;
  }

  private void whole(long number) {
    if (number < 0) {
      head(NEGATIVE, -1 - number);
    } else {
      head(WHOLE, number);
    }
  }

  private void text(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    head(TEXT, bytes.length);
    out.writeBytes(bytes);
  }

  private void bytes(byte[] bytes) {
    head(BYTES, bytes.length);
    out.writeBytes(bytes);
  }

  /** A type, and a number without a sign in as few bytes as it needs. */
  private void head(int major, long number) {
    if (number >= 0 && number < 24) {
      out.write(major << 5 | (int) number);
      return;
    }
    int size = number >>> 8 == 0 ? 1 : number >>> 16 == 0 ? 2 : number >>> 32 == 0 ? 4 : 8;
    out.write(major << 5 | 24 + Integer.numberOfTrailingZeros(size));
    for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) {
      out.write((int) (number >>> shift));
    }
  }
}

package org.urbi.ros.codec;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.Field;
import org.urbi.ros.message.FieldType;
import org.urbi.ros.message.MessageDefinition;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Primitive;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.TypeName;
import urbi.UDictionary;

/**
 * Messages of one type as bytes: as ROS 1 has them, or in CDR behind the four bytes that say so.
 * May be used by any threads.
 */
public final class MessageCodec {
  /** What precedes CDR: which order of bytes, and two bytes without a meaning. */
  private static final int HEADER = 4;

  private static final int BIG_ENDIAN = 0;
  private static final int LITTLE_ENDIAN = 1;

  private final MessageType type;
  private final StructPart message;

  /** What is sent again and again has the same size mostly, and then its bytes are copied once. */
  private volatile int lastSize;

  private MessageCodec(MessageType type) {
    this.type = type;
    this.message = new Parts(type).message(type.definition());
  }

  /** The codec of a type, as its version of ROS sends it. */
  public static MessageCodec of(MessageType type) {
    return new MessageCodec(type);
  }

  /** The type. */
  public MessageType type() {
    return type;
  }

  /**
   * A message as bytes.
   *
   * @throws org.urbi.ros.message.ValueException if it is not of the type: which field, and why
   */
  public byte[] encode(UDictionary value) {
    return encode(value, ByteOrder.LITTLE_ENDIAN);
  }

  /** Encodes a message in that order of bytes, which only ROS 2 has. */
  byte[] encode(UDictionary value, ByteOrder order) {
    boolean cdr = type.dialect() == Dialect.ROS_2;
    Output out =
        cdr
            ? new Output(true, HEADER, order, lastSize)
            : new Output(false, 0, ByteOrder.LITTLE_ENDIAN, lastSize);
    message.write(out, value);
    byte[] bytes = out.bytes();
    lastSize = bytes.length;
    if (cdr) {
      bytes[1] = (byte) (order == ByteOrder.LITTLE_ENDIAN ? LITTLE_ENDIAN : BIG_ENDIAN);
    }
    return bytes;
  }

  /**
   * The message that bytes are.
   *
   * @throws CodecException if they are none
   */
  public UDictionary decode(byte[] data) {
    return decode(data, 0, data.length);
  }

  /**
   * The message that the bytes of a buffer are, which is one of an array.
   *
   * @throws CodecException if they are none
   */
  public UDictionary decode(ByteBuffer data) {
    return decode(data.array(), data.arrayOffset() + data.position(), data.remaining());
  }

  /**
   * The message that bytes are.
   *
   * @throws CodecException if they are none
   */
  public UDictionary decode(byte[] data, int offset, int length) {
    if (type.dialect() == Dialect.ROS_1) {
      Input in = new Input(false, data, offset, length, ByteOrder.LITTLE_ENDIAN);
      UDictionary read = message.readMessage(in);
      if (in.remaining() > 0) {
        throw new CodecException("the message goes on where it should end: another type?");
      }
      return read;
    }
    if (length < HEADER || data[offset] != 0 || data[offset + 1] >> 1 != 0) {
      throw new CodecException("the message is no CDR as ROS 2 sends it");
    }
    ByteOrder order =
        data[offset + 1] == LITTLE_ENDIAN ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
    return message.readMessage(new Input(true, data, offset + HEADER, length - HEADER, order));
  }

  /** Makes the parts of a type, one for each message in it. */
  private record Parts(MessageType type, Map<TypeName, StructPart> known) {
    Parts(MessageType type) {
      this(type, new HashMap<>());
    }

    StructPart message(MessageDefinition definition) {
      StructPart found = known.get(definition.name());
      if (found == null) {
        List<String> names = new ArrayList<>();
        List<Part> parts = new ArrayList<>();
        for (Field field : definition.fields()) {
          names.add(field.name());
          parts.add(part(field.type()));
        }
        boolean filled = definition.dialect() == Dialect.ROS_2 && parts.isEmpty();
        String name = definition.name().in(definition.dialect());
        found = new StructPart(name, names, parts, filled ? 1 : 0);
        known.put(definition.name(), found);
      }
      return found;
    }

    private Part part(FieldType field) {
      return switch (field) {
        case FieldType.Basic(Primitive primitive) ->
            primitive.isInstant()
                ? InstantPart.of(primitive)
                : new NumberPart(primitive, type.dialect());
        case FieldType.Text text -> new TextPart(text);
        case FieldType.Nested(TypeName name) -> message(type.definition(name));
        case FieldType.Array array ->
            Templates.isBytes(array, type.dialect())
                ? new BytesPart(array)
                : new ArrayPart(array, part(array.element()));
      };
    }
  }
}

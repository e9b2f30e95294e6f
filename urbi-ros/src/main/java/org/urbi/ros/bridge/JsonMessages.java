package org.urbi.ros.bridge;

import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.message.Field;
import org.urbi.ros.message.FieldType;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Primitive;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.TypeName;
import org.urbi.ros.message.ValueException;
import urbi.UBinary;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/**
 * Messages as rosbridge writes them: bytes in Base64, truth values as such, the times of ROS 1 with
 * {@code secs} and {@code nsecs}. Of what comes, fields may be missing: they are as in a new
 * message.
 */
final class JsonMessages {
  private static final String SECS = "secs";
  private static final String NSECS = "nsecs";

  private JsonMessages() {}

  // ------------------------------------------------------------------ to JSON

  static Map<String, @Nullable Object> json(UDictionary message, MessageType type) {
    Map<String, @Nullable Object> all = new LinkedHashMap<>();
    for (Field field : type.definition().fields()) {
      UValue value = message.get(field.name());
      all.put(field.name(), value == null ? null : json(value, field.type(), type));
    }
    return all;
  }

  private static @Nullable Object json(UValue value, FieldType type, MessageType within) {
    return switch (type) {
      case FieldType.Basic(Primitive primitive) -> {
        if (primitive.isInstant()) {
          UDictionary time = value.udictionaryValue();
          Map<String, @Nullable Object> both = new LinkedHashMap<>();
          both.put(SECS, number(time.get(Templates.SECONDS)));
          both.put(NSECS, number(time.get(Templates.NANOSECONDS)));
          yield both;
        }
        yield primitive == Primitive.BOOL
            ? Boolean.valueOf(value.doubleValue() != 0)
            : (Object) value.doubleValue();
      }
      case FieldType.Text text -> value.stringValue();
      case FieldType.Nested(TypeName name) -> json(value.udictionaryValue(), within.part(name));
      case FieldType.Array array -> {
        if (value.getType() == UDataType.DATA_BINARY) {
          yield Base64.getEncoder().encodeToString(value.ubinaryValue().getData());
        }
        List<@Nullable Object> list = new ArrayList<>();
        for (UValue each : value.ulistValue()) {
          list.add(json(each, array.element(), within));
        }
        yield list;
      }
    };
  }

  private static double number(@Nullable UValue value) {
    return value == null ? 0 : value.doubleValue();
  }

  // ------------------------------------------------------------------ from JSON

  /**
   * A message; whether its values fit is seen when it is sent.
   *
   * @throws ValueException if it has a field that the type has not
   */
  static UDictionary message(Map<String, @Nullable Object> json, MessageType type) {
    UDictionary message = Templates.of(type);
    json.forEach((key, value) -> {
      Field field =
          type.definition().fields().stream()
              .filter(each -> each.name().equals(key))
              .findFirst()
              .orElseThrow(() -> noSuchField(key, type));
      try {
        message.put(key, value(value, field.type(), type));
      } catch (ValueException e) {
        throw e.within(key);
      }
    });
    return message;
  }

  private static ValueException noSuchField(String key, MessageType type) {
    return new ValueException(type.name().in(type.dialect()) + " has no such field").within(key);
  }

  private static UValue value(@Nullable Object json, FieldType type, MessageType within) {
    return switch (type) {
      case FieldType.Basic(Primitive primitive) ->
          primitive.isInstant() ? instant(json) : number(json);
      case FieldType.Text text -> new UValue(expected(String.class, json, "a string"));
      case FieldType.Nested(TypeName name) ->
          new UValue(
              message(JsonReader.map(expected(Map.class, json, "an object")), within.part(name)));
      case FieldType.Array array -> {
        if (json instanceof String text && Templates.isBytes(array, within.dialect())) {
          yield new UValue(new UBinary(bytes(text)));
        }
        UList list = new UList();
        int index = 0;
        for (Object each : expected(List.class, json, "a list")) {
          try {
            list.push_back(value(each, array.element(), within));
          } catch (ValueException e) {
            throw e.within("[" + index + "]");
          }
          index++;
        }
        yield new UValue(list);
      }
    };
  }

  private static <T> T expected(Class<T> type, @Nullable Object json, String what) {
    if (!type.isInstance(json)) {
      throw new ValueException(what + " expected");
    }
    return type.cast(json);
  }

  private static UValue number(@Nullable Object json) {
    return switch (json) {
      case Double number -> new UValue(number.doubleValue());
      case Boolean truth -> new UValue(truth ? 1.0 : 0.0);
      // JSON has no NaN and writes null for it.
      case null -> new UValue(Double.NaN);
      default -> throw new ValueException("a number expected");
    };
  }

  private static UValue instant(@Nullable Object json) {
    Map<String, @Nullable Object> both =
        JsonReader.map(expected(Map.class, json, "an object with secs and nsecs"));
    return Templates.instant(
        part(both, SECS, Templates.SECONDS), part(both, NSECS, Templates.NANOSECONDS));
  }

  private static double part(Map<String, @Nullable Object> time, String name, String otherName) {
    Object value = time.containsKey(name) ? time.get(name) : time.get(otherName);
    return value instanceof Double number ? number : 0;
  }

  private static byte[] bytes(String base64) {
    try {
      return Base64.getDecoder().decode(base64);
    } catch (IllegalArgumentException e) {
      throw new ValueException("Base64 expected");
    }
  }
}

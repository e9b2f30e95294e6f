package org.urbi.ros.message;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;

/** What tells whether two programs mean the same by the name of a type. */
public final class TypeHash {
  /** What messages of ROS 2 without fields have: there a structure has one at least. */
  private static final Field FILLER =
      new Field("structure_needs_at_least_one_member", new FieldType.Basic(Primitive.UINT8), null);

  /** What a connection of ROS 1 says that takes any type. */
  public static final String ANY_MD5 = "*";

  private TypeHash() {}

  private static String digest(String algorithm, String text) {
    try {
      return HexFormat.of()
          .formatHex(
              MessageDigest.getInstance(algorithm).digest(text.getBytes(StandardCharsets.UTF_8)));
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("every Java platform has " + algorithm, e);
    }
  }

  // ------------------------------------------------------------------ ROS 1

  /** The MD5 sum of a message of ROS 1, in hexadecimal digits. */
  public static String md5(MessageType type) {
    return md5(type.definition(), type, new HashMap<>());
  }

  /** The MD5 sum of a service of ROS 1, in hexadecimal digits. */
  public static String md5(ServiceType type) {
    return digest("MD5", text(type.request()) + text(type.response()));
  }

  private static String text(MessageType type) {
    return text(type.definition(), type, new HashMap<>());
  }

  private static String md5(
      MessageDefinition definition, MessageType within, Map<TypeName, String> known) {
    String found = known.get(definition.name());
    if (found == null) {
      found = digest("MD5", text(definition, within, known));
      known.put(definition.name(), found);
    }
    return found;
  }

  private static String text(
      MessageDefinition definition, MessageType within, Map<TypeName, String> known) {
    List<String> lines = new ArrayList<>();
    for (Constant constant : definition.constants()) {
      lines.add(TypeReader.write(constant.type()) + " " + constant.name() + "=" + constant.text());
    }
    for (Field field : definition.fields()) {
      FieldType element =
          field.type() instanceof FieldType.Array array ? array.element() : field.type();
      String type =
          element instanceof FieldType.Nested(TypeName name)
              ? md5(within.definition(name), within, known)
              : TypeReader.write(field.type());
      lines.add(type + " " + field.name());
    }
    return String.join("\n", lines);
  }

  // ------------------------------------------------------------------ ROS 2

  /** The hash of a type of ROS 2, as it is written: {@code RIHS01_…}. */
  public static String rihs(MessageType type) {
    StringBuilder json = new StringBuilder("{\"type_description\": ");
    describe(json, type.definition());
    json.append(", \"referenced_type_descriptions\": [");
    String separator = "";
    for (MessageDefinition each : type.referenced().values()) {
      json.append(separator);
      describe(json, each);
      separator = ", ";
    }
    return "RIHS01_" + digest("SHA-256", json.append("]}").toString());
  }

  private static void describe(StringBuilder json, MessageDefinition definition) {
    json.append("{\"type_name\": \"").append(definition.name()).append("\", \"fields\": [");
    String separator = "";
    for (Field field : wireFields(definition)) {
      json.append(separator).append("{\"name\": \"").append(field.name()).append("\", \"type\": ");
      describe(json, field.type());
      json.append('}');
      separator = ", ";
    }
    json.append("]}");
  }

  /** The fields that are sent: there is one at least in a message of ROS 2. */
  private static List<Field> wireFields(MessageDefinition definition) {
    boolean filled = definition.dialect() == Dialect.ROS_2 && definition.fields().isEmpty();
    return filled ? List.of(FILLER) : definition.fields();
  }

  private static void describe(StringBuilder json, FieldType type) {
    FieldType element = type instanceof FieldType.Array array ? array.element() : type;
    int id =
        element(element)
            + (type instanceof FieldType.Array array
                ? switch (array.length()) {
                  case FIXED -> 48;
                  case BOUNDED -> 96;
                  case ANY -> 144;
                }
                : 0);
    json.append("{\"type_id\": ")
        .append(id)
        .append(", \"capacity\": ")
        .append(type instanceof FieldType.Array array ? array.size() : 0)
        .append(", \"string_capacity\": ")
        .append(element instanceof FieldType.Text text ? text.limit() : 0)
        .append(", \"nested_type_name\": \"")
        .append(element instanceof FieldType.Nested nested ? nested.name() : "")
        .append("\"}");
  }

  /** The numbers of {@code type_description_interfaces/msg/FieldType}. */
  private static int element(FieldType type) {
    return switch (type) {
      case FieldType.Nested nested -> 1;
      case FieldType.Text(boolean wide, int limit) -> (limit == 0 ? 17 : 21) + (wide ? 1 : 0);
      case FieldType.Basic(Primitive primitive) ->
          switch (primitive) {
            case INT8 -> 2;
            case UINT8, CHAR -> 3;
            case INT16 -> 4;
            case UINT16 -> 5;
            case INT32 -> 6;
            case UINT32 -> 7;
            case INT64 -> 8;
            case UINT64 -> 9;
            case FLOAT32 -> 10;
            case FLOAT64 -> 11;
            case BOOL -> 15;
            case BYTE -> 16;
            case TIME, DURATION -> throw new DefinitionException("time is a type of ROS 1 only");
          };
      case FieldType.Array array -> throw new DefinitionException("arrays of arrays do not exist");
    };
  }
}

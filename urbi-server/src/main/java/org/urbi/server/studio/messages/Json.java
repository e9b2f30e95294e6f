package org.urbi.server.studio.messages;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.observe.Bytes;

/** JSON of values: Doubles, Booleans, Strings, Lists, Maps, binaries, and null. */
public final class Json {
  private static final int DEEPEST = 24;
  private static final int LONGEST_NUMBER = 30;

  private static final JsonFactory FACTORY =
      JsonFactory.builder()
          .streamReadConstraints(
              StreamReadConstraints.builder()
                  .maxNestingDepth(DEEPEST)
                  .maxNumberLength(LONGEST_NUMBER)
                  .build())
          .build();

  /** Writes a part of a text. */
  @FunctionalInterface
  public interface Content {
    void write(JsonGenerator out) throws IOException;
  }

  private Json() {}

  /** An object, in UTF-8. */
  public static byte[] object(Content fields) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (JsonGenerator out = FACTORY.createGenerator(bytes)) {
      out.writeStartObject();
      fields.write(out);
      out.writeEndObject();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  /** A map of values as an object, in UTF-8. */
  public static byte[] object(Map<?, ?> values) {
    return object(out -> {
      for (Map.Entry<?, ?> each : values.entrySet()) {
        out.writeFieldName(String.valueOf(each.getKey()));
        write(out, each.getValue());
      }
    });
  }

  /** Writes a value. What JSON has no number for (infinity, nan) becomes null. */
  public static void write(JsonGenerator out, @Nullable Object value) throws IOException {
    switch (value) {
      case Double number -> {
        if (Double.isFinite(number)) {
          out.writeNumber(number);
        } else {
          out.writeNull();
        }
      }
      case Boolean truth -> out.writeBoolean(truth);
      case String text -> out.writeString(text);
      case List<?> list -> {
        out.writeStartArray();
        for (Object each : list) {
          write(out, each);
        }
        out.writeEndArray();
      }
      case Map<?, ?> map -> {
        out.writeStartObject();
        for (Map.Entry<?, ?> each : map.entrySet()) {
          out.writeFieldName(String.valueOf(each.getKey()));
          write(out, each.getValue());
        }
        out.writeEndObject();
      }
      case Bytes binary -> {
        out.writeStartObject();
        out.writeStringField("keywords", binary.keywords());
        out.writeBinaryField("data", binary.bytes());
        out.writeEndObject();
      }
      case null, default -> out.writeNull();
    }
  }

  /**
   * Reads a text, which must be one object.
   *
   * @throws BadMessage if it is none
   */
  public static Map<String, @Nullable Object> read(byte[] text) throws BadMessage {
    try (JsonParser parser = FACTORY.createParser(text)) {
      if (parser.nextToken() != JsonToken.START_OBJECT) {
        throw new BadMessage("a JSON object expected");
      }
      Map<String, @Nullable Object> object = object(parser);
      if (parser.nextToken() != null) {
        throw new BadMessage("one JSON object expected, not more");
      }
      return object;
    } catch (IOException e) {
      throw new BadMessage(
          "no JSON: " + String.valueOf(e.getMessage()).lines().findFirst().orElse(""));
    }
  }

  private static Map<String, @Nullable Object> object(JsonParser parser) throws IOException {
    Map<String, @Nullable Object> object = new LinkedHashMap<>();
    while (parser.nextToken() != JsonToken.END_OBJECT) {
      String name = parser.currentName();
      parser.nextToken();
      object.put(name, value(parser));
    }
    return object;
  }

  private static @Nullable Object value(JsonParser parser) throws IOException {
    return switch (parser.currentToken()) {
      case VALUE_STRING -> parser.getText();
      case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> parser.getDoubleValue();
      case VALUE_TRUE -> true;
      case VALUE_FALSE -> false;
      case START_OBJECT -> object(parser);
      case START_ARRAY -> {
        List<@Nullable Object> list = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
          list.add(value(parser));
        }
        yield list;
      }
      default -> null;
    };
  }
}

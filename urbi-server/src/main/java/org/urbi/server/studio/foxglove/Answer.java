package org.urbi.server.studio.foxglove;

import com.fasterxml.jackson.core.JsonGenerator;
import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.handler.codec.http.websocketx.BinaryWebSocketFrame;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Version;
import org.urbi.server.studio.messages.Form;
import org.urbi.server.studio.messages.Json;
import org.urbi.server.studio.messages.Topic;

/** What a program is sent. */
final class Answer {
  /** How bad it is that a program is told of. */
  enum Level {
    INFO,
    WARNING,
    ERROR
  }

  private static final byte MESSAGE = 1;
  private static final byte TIME = 2;
  private static final byte CALL_RESPONSE = 3;

  private Answer() {}

  private static TextWebSocketFrame text(String op, Json.Content content) {
    return new TextWebSocketFrame(
        Unpooled.wrappedBuffer(
            Json.object(out -> {
              out.writeStringField("op", op);
              content.write(out);
            })));
  }

  private static void write(JsonGenerator out, String name, Collection<String> texts)
      throws IOException {
    out.writeArrayFieldStart(name);
    for (String each : texts) {
      out.writeString(each);
    }
    out.writeEndArray();
  }

  /** The first thing that a program is told. An observer has nothing to publish, and to call. */
  static TextWebSocketFrame serverInfo(Role role) {
    return text(
        "serverInfo",
        out -> {
          out.writeStringField("name", "Urbi " + Version.number());
          write(
              out,
              "capabilities",
              role == Role.OBSERVER
                  ? List.of("parameters", "parametersSubscribe", "time")
                  : List.of(
                      "clientPublish", "parameters", "parametersSubscribe", "services", "time"));
          write(out, "supportedEncodings", List.of("json"));
          out.writeObjectFieldStart("metadata");
          out.writeStringField("role", role.text());
          out.writeEndObject();
        });
  }

  /** Tells people who look at the program something. */
  static TextWebSocketFrame status(Level level, String message) {
    return text(
        "status",
        out -> {
          out.writeNumberField("level", level.ordinal());
          out.writeStringField("message", message);
        });
  }

  /**
   * There are channels.
   *
   * @param channels by their numbers
   * @param forms how the messages of each are written
   */
  static TextWebSocketFrame advertise(Map<Integer, Topic> channels, Function<Topic, Form> forms) {
    return text(
        "advertise",
        out -> {
          out.writeArrayFieldStart("channels");
          for (Map.Entry<Integer, Topic> each : channels.entrySet()) {
            Topic topic = each.getValue();
            Form form = forms.apply(topic);
            out.writeStartObject();
            out.writeNumberField("id", each.getKey());
            out.writeStringField("topic", topic.name());
            out.writeStringField("encoding", form.messageEncoding());
            out.writeStringField("schemaName", form.schemaName());
            out.writeStringField("schema", form.schema());
            out.writeStringField("schemaEncoding", form.schemaEncoding());
            out.writeEndObject();
          }
          out.writeEndArray();
        });
  }

  /** Channels are no more. */
  static TextWebSocketFrame unadvertise(Collection<Integer> channels) {
    return text(
        "unadvertise",
        out -> {
          out.writeArrayFieldStart("channelIds");
          for (int each : channels) {
            out.writeNumber(each);
          }
          out.writeEndArray();
        });
  }

  /** There is the service by which functions are called. */
  static TextWebSocketFrame advertiseCalls() {
    return text(
        "advertiseServices",
        out -> {
          out.writeArrayFieldStart("services");
          out.writeStartObject();
          out.writeNumberField("id", CallService.ID);
          out.writeStringField("name", CallService.NAME);
          out.writeStringField("type", CallService.TYPE);
          writeSchema(out, "request", CallService.TYPE + "Request", CallService.REQUEST);
          writeSchema(out, "response", CallService.TYPE + "Response", CallService.RESPONSE);
          out.writeEndObject();
          out.writeEndArray();
        });
  }

  private static void writeSchema(JsonGenerator out, String name, String title, String schema)
      throws IOException {
    // Older clients know the text alone.
    out.writeStringField(name + "Schema", schema);
    out.writeObjectFieldStart(name);
    out.writeStringField("encoding", "json");
    out.writeStringField("schemaName", title);
    out.writeStringField("schemaEncoding", "jsonschema");
    out.writeStringField("schema", schema);
    out.writeEndObject();
  }

  /** What a function has returned. */
  static BinaryWebSocketFrame called(long call, @Nullable Object value) {
    byte[] encoding = "json".getBytes(StandardCharsets.US_ASCII);
    byte[] content =
        Json.object(out -> {
          out.writeFieldName("value");
          Json.write(out, value);
        });
    ByteBuf head = Unpooled.buffer(1 + 3 * Integer.BYTES + encoding.length);
    head.writeByte(CALL_RESPONSE);
    head.writeIntLE(CallService.ID);
    head.writeIntLE((int) call);
    head.writeIntLE(encoding.length);
    head.writeBytes(encoding);
    return new BinaryWebSocketFrame(Unpooled.wrappedBuffer(head, Unpooled.wrappedBuffer(content)));
  }

  /** Why a call came to nothing. */
  static TextWebSocketFrame callFailure(long service, long call, String message) {
    return text(
        "serviceCallFailure",
        out -> {
          out.writeNumberField("serviceId", service);
          out.writeNumberField("callId", call);
          out.writeStringField("message", message);
        });
  }

  /**
   * The values of parameters; those without a value are not there.
   *
   * @param id of the request, if it had one
   */
  static TextWebSocketFrame parameterValues(
      List<String> names, List<? extends @Nullable Object> values, @Nullable String id) {
    return text(
        "parameterValues",
        out -> {
          out.writeArrayFieldStart("parameters");
          for (int i = 0; i < names.size(); i++) {
            Object value = values.get(i);
            out.writeStartObject();
            out.writeStringField("name", names.get(i));
            if (value != null) {
              out.writeFieldName("value");
              Json.write(out, value);
            }
            if (value instanceof Double) {
              out.writeStringField("type", "float64");
            }
            out.writeEndObject();
          }
          out.writeEndArray();
          if (id != null) {
            out.writeStringField("id", id);
          }
        });
  }

  /** A message for a subscription; the time is in nanoseconds since the Epoch. */
  static BinaryWebSocketFrame message(long subscription, long time, byte[] content) {
    ByteBuf head = Unpooled.buffer(1 + Integer.BYTES + Long.BYTES);
    head.writeByte(MESSAGE);
    head.writeIntLE((int) subscription);
    head.writeLongLE(time);
    return new BinaryWebSocketFrame(Unpooled.wrappedBuffer(head, Unpooled.wrappedBuffer(content)));
  }

  /** What time it is in the kernel, in nanoseconds since the Epoch. */
  static BinaryWebSocketFrame time(long time) {
    ByteBuf content = Unpooled.buffer(1 + Long.BYTES);
    content.writeByte(TIME);
    content.writeLongLE(time);
    return new BinaryWebSocketFrame(content);
  }
}

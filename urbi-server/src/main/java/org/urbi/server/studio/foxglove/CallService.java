package org.urbi.server.studio.foxglove;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.ByteBufUtil;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.server.studio.messages.BadMessage;
import org.urbi.server.studio.messages.Json;

/**
 * The service by which programs call functions of urbiscript: a request names the slot, and has the
 * arguments; the response has what was returned.
 */
final class CallService {
  static final String NAME = "/call";
  static final String TYPE = "urbi.Call";
  static final String REQUEST =
      "{\"title\":\"urbi.CallRequest\",\"type\":\"object\",\"properties\":{"
          + "\"function\":{\"type\":\"string\"},\"arguments\":{\"type\":\"array\"}},"
          + "\"required\":[\"function\"]}";
  static final String RESPONSE =
      "{\"title\":\"urbi.CallResponse\",\"type\":\"object\",\"properties\":{\"value\":{}}}";

  /** Its number. */
  static final int ID = 1;

  private static final String JSON = "json";
  private static final int LONGEST_ENCODING = 100;

  /**
   * What a program calls.
   *
   * @param id by which the program knows the call
   * @param path of the slot with the function
   */
  record Call(long id, String path, List<@Nullable Object> arguments) {}

  /** A call that makes no sense; the program is told under its number. */
  static final class Failed extends Exception {
    private static final long serialVersionUID = 1;
    private final long service;
    private final long call;

    private Failed(long service, long call, String message) {
      super(message);
      this.service = service;
      this.call = call;
    }

    long service() {
      return service;
    }

    long call() {
      return call;
    }
  }

  private CallService() {}

  /**
   * Reads a message of a program, without its first byte.
   *
   * @throws BadMessage if it is so short that it is no call at all
   * @throws Failed if it is a call of nothing that there is
   */
  static Call read(ByteBuf frame) throws BadMessage, Failed {
    if (frame.readableBytes() < 3 * Integer.BYTES) {
      throw new BadMessage("a call of a service expected");
    }
    long service = frame.readUnsignedIntLE();
    long id = frame.readUnsignedIntLE();
    long length = frame.readUnsignedIntLE();
    if (service != ID) {
      throw new Failed(service, id, "no such service: " + service);
    }
    if (length > Math.min(LONGEST_ENCODING, frame.readableBytes())) {
      throw new Failed(service, id, "encoding: longer than the message");
    }
    String encoding = frame.readString((int) length, StandardCharsets.UTF_8);
    if (!encoding.equals(JSON)) {
      throw new Failed(service, id, "encoding: json expected, not " + encoding);
    }
    try {
      return call(id, Json.read(ByteBufUtil.getBytes(frame)));
    } catch (BadMessage e) {
      throw new Failed(service, id, String.valueOf(e.getMessage()));
    }
  }

  private static Call call(long id, Map<String, @Nullable Object> request) throws BadMessage {
    if (!(request.get("function") instanceof String function)) {
      throw new BadMessage(
          "function: the path of a slot expected, as in {\"function\": \"robot.go\"}");
    }
    List<@Nullable Object> arguments = new ArrayList<>();
    Object given = request.get("arguments");
    if (given instanceof List<?> list) {
      arguments.addAll(list);
    } else if (given != null) {
      throw new BadMessage("arguments: a list expected");
    }
    return new Call(id, function, arguments);
  }
}

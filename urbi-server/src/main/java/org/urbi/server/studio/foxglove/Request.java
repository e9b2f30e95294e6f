package org.urbi.server.studio.foxglove;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.server.studio.messages.BadMessage;
import org.urbi.server.studio.messages.Json;

/** What a program asks for by text. */
sealed interface Request {
  /** A channel, and the number under which its messages are to be sent. */
  record Subscription(long id, long channel) {}

  record Subscribe(List<Subscription> subscriptions) implements Request {}

  record Unsubscribe(List<Long> subscriptions) implements Request {}

  /** A channel on which the program will send messages. */
  record Publication(long id, String topic, String encoding) {}

  record Advertise(List<Publication> channels) implements Request {}

  record Unadvertise(List<Long> channels) implements Request {}

  /**
   * @param id of the request, which the answer is to have; may be null
   */
  record GetParameters(List<String> names, @Nullable String id) implements Request {}

  record Parameter(String name, @Nullable Object value) {}

  /**
   * @param id of the request, which the answer is to have; may be null
   */
  record SetParameters(List<Parameter> parameters, @Nullable String id) implements Request {}

  /** Which parameters are to be told when they change, or no longer. */
  record WatchParameters(List<String> names, boolean on) implements Request {}

  /**
   * Reads a request.
   *
   * @throws BadMessage if it is none
   */
  static Request read(byte[] text) throws BadMessage {
    Map<String, @Nullable Object> fields = Json.read(text);
    String id = fields.get("id") instanceof String known ? known : null;
    return switch (String.valueOf(fields.get("op"))) {
      case "subscribe" -> {
        List<Subscription> all = new ArrayList<>();
        for (Map<?, ?> each : objects(fields, "subscriptions")) {
          all.add(new Subscription(number(each, "id"), number(each, "channelId")));
        }
        yield new Subscribe(all);
      }
      case "unsubscribe" -> new Unsubscribe(numbers(fields, "subscriptionIds"));
      case "advertise" -> {
        List<Publication> all = new ArrayList<>();
        for (Map<?, ?> each : objects(fields, "channels")) {
          all.add(new Publication(number(each, "id"), text(each, "topic"), text(each, "encoding")));
        }
        yield new Advertise(all);
      }
      case "unadvertise" -> new Unadvertise(numbers(fields, "channelIds"));
      case "getParameters" -> new GetParameters(texts(fields, "parameterNames"), id);
      case "setParameters" -> {
        List<Parameter> all = new ArrayList<>();
        for (Map<?, ?> each : objects(fields, "parameters")) {
          if (each.get("value") == null) {
            throw new BadMessage("value: expected: variables cannot be removed");
          }
          all.add(new Parameter(text(each, "name"), each.get("value")));
        }
        yield new SetParameters(all, id);
      }
      case "subscribeParameterUpdates" ->
          new WatchParameters(texts(fields, "parameterNames"), true);
      case "unsubscribeParameterUpdates" ->
          new WatchParameters(texts(fields, "parameterNames"), false);
      default -> throw new BadMessage("op: not offered by this server: " + fields.get("op"));
    };
  }

  private static List<?> list(Map<?, ?> fields, String name) throws BadMessage {
    if (fields.get(name) instanceof List<?> list) {
      return list;
    }
    throw new BadMessage(name + ": a list expected");
  }

  private static List<Map<?, ?>> objects(Map<?, ?> fields, String name) throws BadMessage {
    List<Map<?, ?>> objects = new ArrayList<>();
    for (Object each : list(fields, name)) {
      if (!(each instanceof Map<?, ?> object)) {
        throw new BadMessage(name + ": objects expected");
      }
      objects.add(object);
    }
    return objects;
  }

  private static List<String> texts(Map<?, ?> fields, String name) throws BadMessage {
    List<String> texts = new ArrayList<>();
    for (Object each : list(fields, name)) {
      if (!(each instanceof String text)) {
        throw new BadMessage(name + ": strings expected");
      }
      texts.add(text);
    }
    return texts;
  }

  private static List<Long> numbers(Map<?, ?> fields, String name) throws BadMessage {
    List<Long> numbers = new ArrayList<>();
    for (Object each : list(fields, name)) {
      numbers.add(whole(each, name));
    }
    return numbers;
  }

  private static long number(Map<?, ?> fields, String name) throws BadMessage {
    return whole(fields.get(name), name);
  }

  private static long whole(@Nullable Object value, String name) throws BadMessage {
    if (value instanceof Double number && number == (long) (double) number && number >= 0) {
      return (long) (double) number;
    }
    throw new BadMessage(name + ": a whole number expected");
  }

  private static String text(Map<?, ?> fields, String name) throws BadMessage {
    if (fields.get(name) instanceof String text) {
      return text;
    }
    throw new BadMessage(name + ": a string expected");
  }
}

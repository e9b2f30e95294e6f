package org.urbi.ros.bridge;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.Failures;

/** What a client is told: as texts, in pieces, in a PNG or in CBOR if it has asked for that. */
final class Replies {
  private static final List<String> LEVELS = List.of("info", "warning", "error", "none");

  private final Outbox outbox;
  private final Runnable letGo;
  private final AtomicInteger fragmented = new AtomicInteger();
  private volatile int level = LEVELS.indexOf("error");

  /**
   * @param letGo ends a client that does not read its answers
   */
  Replies(Outbox outbox, Runnable letGo) {
    this.outbox = outbox;
    this.letGo = letGo;
  }

  void setLevel(String name) {
    int index = LEVELS.indexOf(name);
    if (index < 0) {
      throw new BridgeException("level: one of " + String.join(", ", LEVELS) + " expected");
    }
    level = index;
  }

  /** Tells what went well or wrong, if the client wants to hear that. */
  void status(String kind, String text, @Nullable Object id) {
    if (LEVELS.indexOf(kind) < level) {
      return;
    }
    Map<String, @Nullable Object> status = new LinkedHashMap<>();
    status.put("op", "status");
    if (id != null) {
      status.put("id", id);
    }
    status.put("level", kind);
    status.put("msg", text);
    answer(JsonWriter.text(status));
  }

  /** Tells that an operation failed. */
  void failed(Operation operation, Throwable failure) {
    status("error", operation.text("op") + ": " + reason(failure), operation.id());
  }

  /** What people are told of a failure. */
  static String reason(Throwable failure) {
    return Failures.told("a server of rosbridge", failure);
  }

  /** An answer to what was asked. */
  void answer(Map<String, @Nullable Object> message, Operation asked) {
    shaped(JsonWriter.text(message), asked).forEach(this::answer);
  }

  void answer(String text) {
    if (!outbox.answer(WebSocket.Frame.text(text))) {
      letGo.run();
    }
  }

  /** A message of a topic; the older ones of that subscription may be dropped for it. */
  void publish(Map<String, @Nullable Object> message, Operation asked, Object subscription) {
    List<String> pieces = shaped(JsonWriter.text(message), asked);
    int most = asked.count("queue_length") * pieces.size();
    pieces.forEach(piece -> outbox.publish(WebSocket.Frame.text(piece), subscription, most));
  }

  /** Sends a message of a topic, in CBOR. */
  void publish(byte[] cbor, Operation asked, Object subscription) {
    outbox.publish(WebSocket.Frame.binary(cbor), subscription, asked.count("queue_length"));
  }

  private List<String> shaped(String text, Operation asked) {
    String whole = text;
    if (asked.text("compression").equals("png")) {
      Map<String, @Nullable Object> png = new LinkedHashMap<>();
      png.put("op", "png");
      png.put("data", PngText.encode(text));
      whole = JsonWriter.text(png);
    }
    int size = asked.count("fragment_size");
    if (size == 0 || whole.length() <= size) {
      return List.of(whole);
    }
    return Fragments.split(whole, size, "urbi" + fragmented.incrementAndGet());
  }
}

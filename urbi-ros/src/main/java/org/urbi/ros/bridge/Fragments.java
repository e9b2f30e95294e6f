package org.urbi.ros.bridge;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** Messages in pieces. Of those that come, a few are put together at a time. */
final class Fragments {
  private static final int MOST_MESSAGES = 16;
  private static final int MOST_PIECES = 100_000;

  /** A piece has that many characters at least: what surrounds it is longer than that. */
  private static final int SHORTEST = 100;

  private final Map<String, Incoming> incoming = new LinkedHashMap<>();

  private static final class Incoming {
    final int total;
    final Map<Integer, String> pieces = new HashMap<>();
    long size;

    Incoming(int total) {
      this.total = total;
    }
  }

  static List<String> split(String text, int wanted, String id) {
    int size = Math.max(SHORTEST, wanted);
    int total = (text.length() + size - 1) / size;
    List<String> pieces = new ArrayList<>();
    for (int i = 0; i < total; i++) {
      Map<String, @Nullable Object> piece = new LinkedHashMap<>();
      piece.put("op", "fragment");
      piece.put("id", id);
      piece.put("data", text.substring(i * size, Math.min(text.length(), (i + 1) * size)));
      piece.put("num", i);
      piece.put("total", total);
      pieces.add(JsonWriter.text(piece));
    }
    return pieces;
  }

  /**
   * Another piece has come.
   *
   * @return the whole message, when it was the last one
   * @throws BridgeException if it is none, or there are too many
   */
  @Nullable String add(Operation operation) {
    String id = operation.needed("id");
    int total = operation.count("total");
    int number = operation.count("num");
    if (total == 0 || total > MOST_PIECES || number >= total) {
      throw new BridgeException("'num' below 'total' expected, at most " + MOST_PIECES);
    }
    Incoming message = incoming.computeIfAbsent(id, key -> new Incoming(total));
    String data = operation.text("data");
    if (message.total != total || message.pieces.putIfAbsent(number, data) != null) {
      incoming.remove(id);
      throw new BridgeException("the pieces of " + id + " do not fit together");
    }
    message.size += data.length();
    if (size() > WebSocket.LONGEST) {
      incoming.remove(id);
      throw new BridgeException("messages have " + WebSocket.LONGEST + " characters at most");
    }
    if (message.pieces.size() < total) {
      if (incoming.size() > MOST_MESSAGES) {
        incoming.remove(incoming.keySet().iterator().next());
        throw new BridgeException("too many messages in pieces: the oldest is forgotten");
      }
      return null;
    }
    incoming.remove(id);
    StringBuilder whole = new StringBuilder();
    for (int i = 0; i < total; i++) {
      whole.append(message.pieces.get(i));
    }
    return whole.toString();
  }

  private long size() {
    return incoming.values().stream().mapToLong(each -> each.size).sum();
  }
}

package org.urbi.ros.bridge;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** One message of a client, whose keys are looked at one after the other. */
record Operation(Map<String, @Nullable Object> keys) {
  /** The text of a key; empty if it has none. */
  String text(String key) {
    return keys.get(key) instanceof String text ? text : "";
  }

  /**
   * The text of a key.
   *
   * @throws BridgeException if it has none
   */
  String needed(String key) {
    String text = text(key);
    if (text.isEmpty()) {
      throw new BridgeException("'" + key + "' is missing");
    }
    return text;
  }

  /** A whole number that is not negative; 0 if there is none. */
  int count(String key) {
    return keys.get(key) instanceof Double number && number > 0
        ? (int) Math.min(number, Integer.MAX_VALUE)
        : 0;
  }

  boolean truth(String key) {
    return Boolean.TRUE.equals(keys.get(key));
  }

  /** The identity that answers bear; null if it has none. */
  @Nullable Object id() {
    return keys.get("id");
  }

  /** An object; empty if there is none. */
  Map<String, @Nullable Object> object(String key) {
    Object value = keys.get(key);
    if (value == null) {
      return Map.of();
    }
    if (!(value instanceof Map<?, ?>)) {
      throw new BridgeException("'" + key + "': an object expected");
    }
    return JsonReader.map(value);
  }

  /** A list; null if it is none. */
  @Nullable List<?> list(String key) {
    return keys.get(key) instanceof List<?> list ? list : null;
  }
}

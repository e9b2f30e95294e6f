package org.urbi.kernel.message;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import urbi.UValue;

/**
 * A value that is nothing but data, which can be written down and read again in another process:
 * null, a Boolean, Integer, Long, Double, String, {@code byte[]}, Duration, Path, Internet address,
 * {@link UValue} or {@link Handle}, or a List or Map of these.
 *
 * @param value which must not be changed any more
 */
public record Data(@Nullable Object value) {
  /** An object of urbiscript that a program has got to know by that number. */
  public record Handle(int number) {}

  /**
   * @throws IllegalArgumentException if it is something else, such as an open file
   */
  public Data {
    check(value);
  }

  private static void check(@Nullable Object value) {
    if (value instanceof List<?> list) {
      list.forEach(Data::check);
    } else if (value instanceof Map<?, ?> map) {
      map.forEach((key, each) -> {
        check(key);
        check(each);
      });
    } else if (!(value == null
        || value instanceof String
        || value instanceof Double
        || value instanceof Boolean
        || value instanceof Integer
        || value instanceof Long
        || value instanceof byte[]
        || value instanceof Handle
        || value instanceof UValue
        || value instanceof Path
        || value instanceof InetSocketAddress
        || value instanceof Duration)) {
      throw new IllegalArgumentException(value.getClass().getName());
    }
  }
}

package org.urbi.kernel.embed;

import java.lang.reflect.Array;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.message.Data;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;

/**
 * What the program gives to the kernel with one request: its values, read on the thread of the
 * program as data (see {@link JavaValues}), and the objects whose handles are among them. Texts are
 * urbiscript's then: each character is a byte.
 */
final class GivenValues {
  private final Embedding embedding;

  /** The containers around the value that is being read, to detect cycles. */
  private final List<Object> around = new ArrayList<>();

  private final Map<Integer, UrbiObject> objects = new HashMap<>();

  GivenValues(Embedding embedding) {
    this.embedding = embedding;
  }

  /** The objects behind the handles, by number. */
  Map<Integer, UrbiObject> objects() {
    return objects;
  }

  /** The number of a handle. */
  int number(UrbiValue handle) {
    objects.put(handle.number(), handle.object(embedding));
    return handle.number();
  }

  /**
   * Reads a value.
   *
   * @throws IllegalArgumentException if urbiscript has no corresponding type
   */
  Data value(@Nullable Object value) {
    return new Data(read(value));
  }

  /**
   * Reads arguments.
   *
   * @throws IllegalArgumentException if urbiscript has no corresponding type
   */
  Data list(Object[] values) {
    return new Data(list(Arrays.asList(values)));
  }

  private @Nullable Object read(@Nullable Object value) {
    return switch (value) {
      case null -> null;
      case Boolean truth -> truth;
      case Number number -> number.doubleValue();
      case CharSequence text -> Utf8Text.toUrbi(text.toString());
      case Character c -> Utf8Text.toUrbi(c.toString());
      case byte[] raw -> new String(raw, StandardCharsets.ISO_8859_1);
      case Duration duration -> duration;
      case UrbiValue handle -> new Data.Handle(number(handle));
      default -> container(value);
    };
  }

  private Object container(Object value) {
    for (Object container : around) {
      if (container == value) {
        throw new IllegalArgumentException(Problem.CONTAINS_ITSELF.text());
      }
    }
    if (around.size() >= JavaValues.DEEPEST) {
      throw new IllegalArgumentException(Problem.CONTAINERS_TOO_DEEP.text());
    }
    around.addLast(value);
    try {
      return switch (value) {
        case Map<?, ?> map -> map(map);
        case Collection<?> collection -> list(collection);
        default -> list(elements(value));
      };
    } finally {
      around.removeLast();
    }
  }

  private static Collection<Object> elements(Object array) {
    if (!array.getClass().isArray()) {
      throw new IllegalArgumentException(Problem.NOTHING_LIKE.text(array.getClass().getName()));
    }
    List<Object> elements = new ArrayList<>();
    for (int i = 0; i < Array.getLength(array); i++) {
      elements.add(Array.get(array, i));
    }
    return elements;
  }

  private List<@Nullable Object> list(Collection<?> collection) {
    List<@Nullable Object> list = new ArrayList<>(collection.size());
    for (Object element : collection) {
      list.add(read(element));
    }
    return Collections.unmodifiableList(list);
  }

  private Map<@Nullable Object, @Nullable Object> map(Map<?, ?> map) {
    Map<@Nullable Object, @Nullable Object> read = new LinkedHashMap<>();
    map.forEach((key, content) -> read.put(read(key), read(content)));
    return Collections.unmodifiableMap(read);
  }
}

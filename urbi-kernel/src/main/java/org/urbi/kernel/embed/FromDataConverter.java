package org.urbi.kernel.embed;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.message.Data;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;

/** Makes objects of urbiscript from what {@link GivenValues} has read; on the kernel thread. */
final class FromDataConverter {
  private final Frame frame;
  private final Values values;
  private final Map<Integer, UrbiObject> objects;

  /**
   * @param objects behind the handles in the data, by number
   */
  FromDataConverter(Frame frame, Map<Integer, UrbiObject> objects) {
    this.frame = frame;
    this.values = frame.interpreter().values();
    this.objects = objects;
  }

  UrbiObject object(Data data) {
    return object(data.value());
  }

  UrbiObject[] arguments(Data data) {
    return requireNonNull((List<?>) data.value(), "arguments are a list").stream()
        .map(this::object)
        .toArray(UrbiObject[]::new);
  }

  private UrbiObject object(@Nullable Object value) {
    return switch (value) {
      case null -> values.nil;
      case Boolean truth -> values.bool(truth);
      case Double number -> values.number(number);
      case String bytes -> values.string(bytes);
      case Duration time -> duration(time.getSeconds() + time.getNano() / 1e9);
      case Data.Handle handle ->
          requireNonNull(objects.get(handle.number()), "whoever has a handle keeps its object");
      case List<?> list -> list(list);
      case Map<?, ?> map -> dictionary(map);
      default -> throw new IllegalArgumentException(value.toString());
    };
  }

  private UrbiObject duration(double seconds) {
    return new UrbiFloat(frame.interpreter().world().prototype("Duration").cloneShape(), seconds);
  }

  private UrbiObject list(List<?> list) {
    Elements made = new Elements(list.size());
    list.forEach(element -> made.add(object(element)));
    return values.listOf(made);
  }

  private UrbiObject dictionary(Map<?, ?> map) {
    Map<UrbiDictionary.Key, UrbiObject> entries = new LinkedHashMap<>();
    map.forEach(
        (key, content) -> entries.put(DictionaryKey.of(frame, object(key)), object(content)));
    return values.dictionary(entries);
  }
}

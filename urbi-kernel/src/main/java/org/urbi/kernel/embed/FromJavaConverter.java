package org.urbi.kernel.embed;

import java.lang.reflect.Array;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.embed.JavaValues.Maker;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.Values;

/** Converts a Java value, which may contain others, to urbiscript; see {@link JavaValues}. */
final class FromJavaConverter {
  private final Embedding embedding;

  /** The containers around the value that is being converted, to detect cycles. */
  private final List<Object> around = new ArrayList<>();

  FromJavaConverter(Embedding embedding) {
    this.embedding = embedding;
  }

  Maker read(@Nullable Object value) {
    return switch (value) {
      case null -> frame -> values(frame).nil;
      case Boolean truth -> frame -> values(frame).bool(truth);
      case Number number -> number(number.doubleValue());
      case CharSequence text -> string(Utf8Text.toUrbi(text.toString()));
      case Character c -> string(Utf8Text.toUrbi(c.toString()));
      case byte[] raw -> string(new String(raw, StandardCharsets.ISO_8859_1));
      case Duration duration -> duration(duration.getSeconds() + duration.getNano() / 1e9);
      case UrbiValue handle -> {
        UrbiObject object = handle.object(embedding);
        yield frame -> object;
      }
      default -> container(value);
    };
  }

  private static Values values(Frame frame) {
    return frame.interpreter().values();
  }

  private static Maker number(double value) {
    return frame -> values(frame).number(value);
  }

  private static Maker string(String bytes) {
    return frame -> values(frame).string(bytes);
  }

  private static Maker duration(double seconds) {
    return frame ->
        new UrbiFloat(frame.interpreter().world().prototype("Duration").cloneShape(), seconds);
  }

  private Maker container(Object value) {
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
        case Map<?, ?> map -> dictionary(map);
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

  private Maker list(Collection<?> collection) {
    List<Maker> makers = new ArrayList<>();
    for (Object element : collection) {
      makers.add(read(element));
    }
    return frame -> {
      Elements made = new Elements(makers.size());
      makers.forEach(maker -> made.add(maker.make(frame)));
      return values(frame).listOf(made);
    };
  }

  private Maker dictionary(Map<?, ?> map) {
    List<Maker> keys = new ArrayList<>();
    List<Maker> contents = new ArrayList<>();
    map.forEach((key, content) -> {
      keys.add(read(key));
      contents.add(read(content));
    });
    return frame -> {
      Map<UrbiDictionary.Key, UrbiObject> entries = new LinkedHashMap<>();
      for (int i = 0; i < keys.size(); i++) {
        entries.put(DictionaryKey.of(frame, keys.get(i).make(frame)), contents.get(i).make(frame));
      }
      return values(frame).dictionary(entries);
    };
  }
}

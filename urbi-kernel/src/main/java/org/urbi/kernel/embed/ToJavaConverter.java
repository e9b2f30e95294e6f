package org.urbi.kernel.embed;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.UrbiTuple;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.Values;

/**
 * Copies a value to Java, see {@link JavaValues}. A container is copied once, however often it
 * occurs; inside itself, or nested very deeply, it becomes a handle.
 */
final class ToJavaConverter {
  /** Stands for the copy of a container that is being copied. */
  private static final Object UNDER_WAY = new Object();

  private final Embedding embedding;
  private final Map<UrbiObject, Object> copies = new IdentityHashMap<>();

  ToJavaConverter(Embedding embedding) {
    this.embedding = embedding;
  }

  @Nullable Object copy(UrbiObject object, int depth) {
    Values values = object.world().values();
    if (object == values.nil || object == values.voidObject || object == values.acceptedVoid) {
      return null;
    }
    if (object == values.trueObject || object == values.falseObject) {
      return object == values.trueObject;
    }
    boolean prototype =
        object == values.floatProto
            || object == values.stringProto
            || object == values.listProto
            || object == values.tupleProto
            || object == values.dictionaryProto;
    return switch (object) {
      case UrbiFloat number when !prototype -> number.value();
      case UrbiString string when !prototype -> Utf8Text.toJava(string.value());
      case UrbiList list when !prototype -> container(list, depth);
      case UrbiTuple tuple when !prototype -> container(tuple, depth);
      case UrbiDictionary dictionary when !prototype -> container(dictionary, depth);
      default -> embedding.handle(object);
    };
  }

  private Object container(UrbiObject object, int depth) {
    Object known = copies.get(object);
    if (known == UNDER_WAY || known == null && depth == JavaValues.DEEPEST) {
      return embedding.handle(object);
    }
    if (known == null) {
      copies.put(object, UNDER_WAY);
      known =
          switch (object) {
            case UrbiList list -> list(list.elements(), depth + 1);
            case UrbiTuple tuple -> list(tuple.elements(), depth + 1);
            case UrbiDictionary dictionary -> map(dictionary, depth + 1);
            default -> throw new IllegalArgumentException("no container");
          };
      copies.put(object, known);
    }
    return known;
  }

  private List<Object> list(List<UrbiObject> elements, int depth) {
    List<Object> list = new ArrayList<>(elements.size());
    for (UrbiObject element : elements) {
      list.add(copy(element, depth));
    }
    return Collections.unmodifiableList(list);
  }

  private Map<Object, Object> map(UrbiDictionary dictionary, int depth) {
    Map<Object, Object> map = new LinkedHashMap<>();
    dictionary
        .entries()
        .forEach((key, value) -> map.put(copy(key.value(), depth), copy(value, depth)));
    return Collections.unmodifiableMap(map);
  }
}

package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.object.UrbiBinary;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.UrbiTuple;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.Values;

/**
 * Copies values for people who look at them: to a Double, Boolean, String, {@link Bytes}, List or
 * Map of these; any other value becomes null, or within a container the name of its type. No
 * function of urbiscript is called, and it takes a limited time.
 */
final class SeenValue {
  /** How many elements all containers of a value may have; the rest is left out. */
  private static final int MOST = 10_000;

  /** How deep containers may be nested. */
  private static final int DEEPEST = 20;

  private final Values values;
  private int left = MOST;

  private SeenValue(Values values) {
    this.values = values;
  }

  /** A copy of a value; null if it is nil, void, code or an object. */
  static @Nullable Object of(UrbiObject value) {
    return new SeenValue(value.world().values()).copy(value, 0);
  }

  private @Nullable Object copy(UrbiObject value, int depth) {
    if (value == values.trueObject || value == values.falseObject) {
      return value == values.trueObject;
    }
    return switch (value) {
      case UrbiFloat number -> number.value();
      case UrbiString text -> Utf8Text.toJava(text.value());
      case UrbiBinary binary -> new Bytes(Utf8Text.toJava(binary.keywords()), binary.data());
      case UrbiList list -> list(list.elements(), depth + 1);
      case UrbiTuple tuple -> list(tuple.elements(), depth + 1);
      case UrbiDictionary dictionary -> dictionary(dictionary, depth + 1);
      default -> null;
    };
  }

  private Object list(List<UrbiObject> elements, int depth) {
    List<@Nullable Object> list = new ArrayList<>(Math.min(elements.size(), left));
    for (UrbiObject element : elements) {
      if (--left < 0 || depth > DEEPEST) {
        break;
      }
      list.add(element(element, depth));
    }
    return list;
  }

  private Object dictionary(UrbiDictionary dictionary, int depth) {
    Map<String, @Nullable Object> map = new LinkedHashMap<>();
    for (Map.Entry<UrbiDictionary.Key, UrbiObject> each : dictionary.entries().entrySet()) {
      if (--left < 0 || depth > DEEPEST) {
        break;
      }
      map.put(
          String.valueOf(element(each.getKey().value(), depth)), element(each.getValue(), depth));
    }
    return map;
  }

  private @Nullable Object element(UrbiObject value, int depth) {
    Object copy = copy(value, depth);
    boolean empty = copy == null && (value == values.nil || value == values.voidObject);
    return copy != null || empty ? copy : type(value);
  }

  private static String type(UrbiObject value) {
    if (!(value instanceof Code)
        && value.lookup(value.world().symbol("type")) instanceof UrbiString type) {
      return Utf8Text.toJava(type.value());
    }
    return value instanceof Code ? "Code" : "Object";
  }
}

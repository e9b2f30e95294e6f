package org.urbi.kernel.observe;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.Values;

/**
 * A slot to which people give a value, or whose function they call.
 *
 * @param owner the object that has it, or inherits it
 * @param name of the slot
 * @param present its value
 */
public record GivenSlot(UrbiObject owner, String name, UrbiObject present) {
  static @Nullable GivenSlot of(SlotPath path) {
    UrbiObject owner = path.owner();
    UrbiObject present = owner == null ? null : path.value();
    return owner == null || present == null ? null : new GivenSlot(owner, path.slot(), present);
  }

  /** A copy of its value, as {@link VariableListener#value} has it. */
  public @Nullable Object seen() {
    return SeenValue.of(present);
  }

  /**
   * Does what is meant by a value for it: an event is emitted with it (a list has one argument in
   * each element, null is none), any other slot is assigned. With the rights of the running code.
   *
   * @param value a Double, Boolean, String, a List or Map of these, or null for nil
   */
  public void give(Frame frame, @Nullable Object value) {
    if (present instanceof UrbiEvent event) {
      List<?> arguments =
          switch (value) {
            case null -> List.of();
            case List<?> list -> list;
            default -> List.of(value);
          };
      frame.interpreter().send(frame, event, "emit", made(frame, arguments));
    } else {
      SlotUpdate.assign(frame, owner, owner.world().symbol(name), made(frame, value));
    }
  }

  /**
   * Calls the function in it, with its owner as the target and the rights of the running code.
   *
   * @param arguments as of {@link #give}
   * @return as of {@link #seen}
   */
  public @Nullable Object call(Frame frame, List<?> arguments) {
    UrbiObject[] made = made(frame, arguments);
    return SeenValue.of(frame.interpreter().send(frame, owner, name, made));
  }

  private static UrbiObject[] made(Frame frame, List<?> arguments) {
    return arguments.stream().map(each -> made(frame, each)).toArray(UrbiObject[]::new);
  }

  private static UrbiObject made(Frame frame, @Nullable Object value) {
    Values values = frame.interpreter().values();
    return switch (value) {
      case Number number -> values.number(number.doubleValue());
      case Boolean truth -> values.bool(truth);
      case String text -> values.string(Utf8Text.toUrbi(text));
      case List<?> list -> {
        Elements elements = new Elements(list.size());
        list.forEach(each -> elements.add(made(frame, each)));
        yield values.listOf(elements);
      }
      case Map<?, ?> map -> {
        Map<UrbiDictionary.Key, UrbiObject> entries = new LinkedHashMap<>();
        map.forEach((key, each) ->
            entries.put(
                DictionaryKey.of(frame, values.string(Utf8Text.toUrbi(String.valueOf(key)))),
                made(frame, each)));
        yield values.dictionary(entries);
      }
      case null, default -> values.nil;
    };
  }
}

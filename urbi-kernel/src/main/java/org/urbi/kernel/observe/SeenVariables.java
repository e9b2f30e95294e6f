package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiBinary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.variable.UrbiConnection;
import org.urbi.kernel.variable.UrbiUVar;

/** The objects that somebody has been told of. On the kernel thread. */
final class SeenVariables {
  /** How many slots of an object are shown. */
  private static final int MOST_SLOTS = 500;

  /** How many readers of a slot are named. */
  private static final int MOST_READERS = 6;

  private static final class Seen {
    private final SentRows<String, SlotRow> slots = new SentRows<>();
    private @Nullable ObjectView before;
  }

  private final Places places;
  private Map<String, Seen> seen = new HashMap<>();

  SeenVariables(Places places) {
    this.places = places;
  }

  /** Looks at objects again, and forgets all others. */
  VariableView look(List<String> ways) {
    Map<String, Seen> now = new HashMap<>();
    List<ObjectView> changed = new ArrayList<>();
    for (String way : ways) {
      Seen known = seen.getOrDefault(way, new Seen());
      now.put(way, known);
      ObjectView view = look(way, known);
      ObjectView frame =
          new ObjectView(
              way,
              false,
              view.found(),
              view.type(),
              view.total(),
              view.protos(),
              List.of(),
              List.of());
      if (!frame.equals(known.before) || !view.slots().isEmpty() || !view.gone().isEmpty()) {
        known.before = frame;
        changed.add(view);
      }
    }
    seen = now;
    return new VariableView(places.roots(), changed);
  }

  private ObjectView look(String way, Seen known) {
    UrbiObject object = places.object(way);
    boolean anew = known.before == null;
    if (object == null) {
      return new ObjectView(way, anew, false, "", 0, List.of(), List.of(), known.slots.gone());
    }
    boolean root = way.indexOf('\n') < 0;
    int total = 0;
    for (Symbol name : object.localSlotNames()) {
      UrbiObject value = object.existingSlot(name);
      // What the system has put into Global is not what people look for there.
      if (!(value instanceof Code) && !(root && isSystems(value)) && ++total <= MOST_SLOTS) {
        SlotRow row = row(new Places.Slot(object, name));
        known.slots.is(row.name(), row);
      }
    }
    List<String> protos = Arrays.stream(object.protos()).map(ValueText::type).toList();
    return new ObjectView(
        way,
        anew,
        true,
        ValueText.type(object),
        total,
        protos,
        known.slots.changes(),
        known.slots.gone());
  }

  private static boolean isSystems(UrbiObject value) {
    return value.ownerLobby() == value.world().values().object;
  }

  private static SlotRow row(Places.Slot slot) {
    UrbiUVar variable = slot.variable();
    UrbiObject value = slot.value();
    SlotData data = slot.holder().slotData(slot.name());
    return new SlotRow(
        Utf8Text.toJava(slot.name().name()),
        ValueText.type(value),
        ValueText.of(value),
        value instanceof UrbiFloat number ? number.value() : Double.NaN,
        opens(value),
        limit(data, "rangemin"),
        limit(data, "rangemax"),
        data != null && data.isConstant(),
        variable != null,
        variable != null && variable.isOwned() ? owner(variable) : "",
        variable == null ? 0 : variable.writes().times(),
        variable == null ? -1 : variable.writes().last(),
        readers(data, variable),
        value instanceof UrbiBinary binary ? Media.kind(binary) : "");
  }

  /** Whether people want to see the slots of a value. */
  private static boolean opens(UrbiObject value) {
    Values values = value.world().values();
    return value != values.nil
        && value != values.voidObject
        && value != values.trueObject
        && value != values.falseObject
        && (value.getClass() == UrbiObject.class || value.localSlotNames().length > 0);
  }

  private static double limit(@Nullable SlotData data, String property) {
    return data != null && data.property(property) instanceof UrbiFloat limit
        ? limit.value()
        : Double.NaN;
  }

  private static String owner(UrbiUVar variable) {
    String name = variable.name();
    return name.substring(0, Math.max(0, name.lastIndexOf('.')));
  }

  private static List<String> readers(@Nullable SlotData data, @Nullable UrbiUVar variable) {
    List<String> all = new ArrayList<>();
    if (data != null && data.dependents() != null) {
      data.dependents().watchers(MOST_READERS).forEach(each -> all.add(Written.brief(each)));
      int more = data.dependents().size() - all.size();
      if (more > 0) {
        all.add(more + " more conditions");
      }
    }
    if (variable != null) {
      for (UrbiConnection each : variable.connections()) {
        UrbiUVar target = each.target();
        if (target != null && all.size() < 2 * MOST_READERS) {
          all.add("→ " + target.name());
        }
      }
      int functions = variable.listenerCount();
      if (functions > 0) {
        all.add(functions + (functions == 1 ? " function" : " functions"));
      }
    }
    return all;
  }
}

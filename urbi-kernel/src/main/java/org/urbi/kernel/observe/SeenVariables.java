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

  /** A look at objects, which has begun. */
  private final class Scan {
    private final List<String> ways;
    private final Map<String, Seen> now = new HashMap<>();
    private final List<ObjectView> changed = new ArrayList<>();
    private int next;
    private @Nullable Slots slots;

    Scan(List<String> ways) {
      this.ways = ways;
    }

    /** Goes on, as far as it is allowed; returns whether it is over. */
    boolean goOn(Allowance allowance) {
      while (next < ways.size() && allowance.isLeft()) {
        allowance.use(1);
        String way = ways.get(next);
        Seen known = now.computeIfAbsent(way, any -> seen.getOrDefault(way, new Seen()));
        Slots going = slots == null ? Slots.of(way, places.object(way), known) : slots;
        slots = going;
        if (going.goOn(allowance)) {
          add(way, known, going.view());
          slots = null;
          next++;
        }
      }
      return next == ways.size();
    }

    private void add(String way, Seen known, ObjectView view) {
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
  }

  /** A look at the slots of an object, which has begun. */
  private static final class Slots {
    private final String way;
    private final @Nullable UrbiObject object;
    private final Seen known;
    private final Symbol[] names;
    private int next;
    private int total;

    private Slots(String way, @Nullable UrbiObject object, Seen known, Symbol[] names) {
      this.way = way;
      this.object = object;
      this.known = known;
      this.names = names;
    }

    static Slots of(String way, @Nullable UrbiObject object, Seen known) {
      return new Slots(
          way, object, known, object == null ? new Symbol[0] : object.localSlotNames());
    }

    /** Goes on, as far as it is allowed; returns whether it is over. */
    boolean goOn(Allowance allowance) {
      UrbiObject holder = object;
      for (; holder != null && next < names.length && allowance.isLeft(); next++) {
        allowance.use(1);
        look(holder, names[next], allowance);
      }
      return next == names.length;
    }

    private void look(UrbiObject holder, Symbol name, Allowance allowance) {
      // It may have been removed since the look began.
      UrbiObject value = holder.localSlot(name);
      boolean root = way.indexOf('\n') < 0;
      // What the system has put into Global is not what people look for there.
      if (value != null
          && !(value instanceof Code)
          && !(root && isSystems(value))
          && ++total <= MOST_SLOTS) {
        allowance.use(Allowance.ROW);
        SlotRow row = row(new Places.Slot(holder, name));
        known.slots.is(row.name(), row);
      }
    }

    ObjectView view() {
      boolean anew = known.before == null;
      UrbiObject holder = object;
      if (holder == null) {
        return new ObjectView(way, anew, false, "", 0, List.of(), List.of(), known.slots.gone());
      }
      List<String> protos = Arrays.stream(holder.protos()).map(ValueText::type).toList();
      return new ObjectView(
          way,
          anew,
          true,
          ValueText.type(holder),
          total,
          protos,
          known.slots.changes(),
          known.slots.gone());
    }
  }

  private final Places places;
  private Map<String, Seen> seen = new HashMap<>();
  private @Nullable Scan scan;

  SeenVariables(Places places) {
    this.places = places;
  }

  /**
   * Looks at objects again, as far as it is allowed, or goes on with that; all others are
   * forgotten.
   *
   * @param ways to the objects; asked when a look begins
   * @return what has changed; null if not all have been looked at yet
   */
  @Nullable VariableView look(List<String> ways, Allowance allowance) {
    Scan going = scan == null ? new Scan(ways) : scan;
    scan = going;
    if (!going.goOn(allowance)) {
      return null;
    }
    scan = null;
    seen = going.now;
    return new VariableView(places.roots(), going.changed);
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

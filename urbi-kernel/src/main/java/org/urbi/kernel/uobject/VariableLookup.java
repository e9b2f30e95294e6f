package org.urbi.kernel.uobject;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.journal.Journal;
import org.urbi.kernel.journal.LooseReference;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.World;
import org.urbi.kernel.variable.UrbiUVar;

/** Finds variables and events by their names: {@code object.slot}. */
final class VariableLookup {
  /** How many variables of unnamed objects are kept before unused ones are removed. */
  private static final int FEW = 64;

  /** A slot of an object. */
  record Place(UrbiObject owner, Symbol slot) {}

  private final World world;
  private final Instances objects;
  private final Journal journal;

  /** Variables of objects that have no name by which they could be found. */
  private final Map<String, LooseReference<UrbiUVar>> handedOut = new HashMap<>();

  private int tidyAt = FEW;

  VariableLookup(World world, Instances objects, Journal journal) {
    this.world = world;
    this.objects = objects;
    this.journal = journal;
  }

  /**
   * The variable of that name. A slot that is not a variable yet becomes one.
   *
   * @throws IllegalArgumentException if there is no such object
   */
  UrbiUVar find(Frame frame, String name) {
    LooseReference<UrbiUVar> handed = handedOut.get(name);
    UrbiUVar known = handed == null ? null : handed.get();
    return known != null ? known : behind(frame, place(frame, name));
  }

  private UrbiUVar behind(Frame frame, Place place) {
    UrbiUVar known = UrbiUVar.behind(place.owner, place.slot);
    if (known != null) {
      return known;
    }
    UrbiObject made = world.prototype("UVar").cloned();
    frame
        .interpreter()
        .send(frame, made, "init", place.owner, world.values().string(place.slot.name()));
    return (UrbiUVar) made;
  }

  /** The slot of that name, which may be missing; the object must exist. */
  Place place(Frame frame, String name) {
    int dot = name.lastIndexOf('.');
    UrbiObject owner = dot <= 0 ? null : owner(frame, name.substring(0, dot));
    if (owner == null || dot == name.length() - 1) {
      throw new KernelRefusal(Problem.NO_OBJECT_FOR_VARIABLE, name);
    }
    return new Place(owner, world.symbol(Utf8Text.toUrbi(name.substring(dot + 1))));
  }

  /**
   * The object of that name.
   *
   * @throws IllegalArgumentException if there is none
   */
  UrbiObject object(Frame frame, String path) {
    UrbiObject found = owner(frame, path);
    if (found == null) {
      throw new IllegalArgumentException(Problem.NO_OBJECT.text(path));
    }
    return found;
  }

  private @Nullable UrbiObject owner(Frame frame, String path) {
    UrbiObject object = objects.find(path);
    if (object != null) {
      return object;
    }
    object = world.prototype("Global");
    for (String step : path.split("\\.")) {
      Symbol slot = world.symbol(Utf8Text.toUrbi(step));
      if (object.locate(slot) == null) {
        return null;
      }
      object = frame.interpreter().get(frame, object, slot);
    }
    return object;
  }

  /** A name of a variable by which it can be found as long as it exists. */
  String handOut(UrbiUVar variable) {
    if (handedOut.size() >= tidyAt) {
      handedOut.values().removeIf(reference -> reference.get() == null);
      tidyAt = Math.max(FEW, 2 * handedOut.size());
    }
    String name = Utf8Text.toJava(variable.name());
    handedOut.put(name, new LooseReference<>(journal, variable));
    return name;
  }

  /** The name by which an object can be found, or at least recognized. */
  String nameOf(Frame frame, UrbiObject object) {
    String name = objects.nameOf(object);
    if (name != null) {
      return Utf8Text.toUrbi(name);
    }
    if (object.lookup(world.symbol("type")) instanceof UrbiString type) {
      Symbol symbol = world.symbol(type.value());
      return world.prototype("Global").lookup(symbol) == object
          ? type.value()
          : type.value() + "_0x" + Long.toHexString(object.uid());
    }
    return "0x" + Long.toHexString(object.uid());
  }
}

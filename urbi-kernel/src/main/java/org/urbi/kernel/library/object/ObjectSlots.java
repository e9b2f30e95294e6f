package org.urbi.kernel.library.object;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.library.lobby.Warnings;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Properties;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.node.TakenCode;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** Slots and their properties (manual, "Object"). */
@UrbiTypePart(value = "Object", needs = Permission.NOTHING)
final class ObjectSlots {
  private ObjectSlots() {}

  private static Symbol symbol(UrbiObject self, String name) {
    return self.world().symbol(name);
  }

  private static UrbiObject found(
      Frame frame, UrbiObject self, String name, @Nullable UrbiObject value) {
    if (value == null) {
      throw frame.interpreter().errors().lookup(self, name);
    }
    return value;
  }

  @Builtin(
      value = {"getSlot", "getSlotValue"},
      doc = "The value of the slot, its own or inherited, not called.")
  static UrbiObject getSlot(Frame frame, UrbiObject self, String name) {
    return TakenCode.by(frame, frame.interpreter().getRaw(self, symbol(self, name)));
  }

  @Builtin(doc = "The value of the object's own slot.")
  static UrbiObject getLocalSlot(Frame frame, UrbiObject self, String name) {
    Symbol symbol = symbol(self, name);
    self.noteStructureRead();
    UrbiObject value = self.localSlot(symbol);
    if (value != null) {
      self.noteSlotRead(symbol);
    }
    if (value == null) {
      throw frame
          .interpreter()
          .errors()
          .of(Problem.NOT_FOUND, name)
          .with("object", self)
          .with("name", name)
          .with("local", self.world().values().trueObject)
          .build();
    }
    return TakenCode.by(frame, value);
  }

  @Builtin(
      value = {"setSlot", "setSlotValue"},
      doc = "Creates a slot with a value; returns the value.",
      needs = Permission.CHANGE)
  static UrbiObject setSlot(Frame frame, UrbiObject self, String name, UrbiObject value) {
    SlotUpdate.create(frame, self, symbol(self, name), value);
    return value;
  }

  @Builtin(
      doc = "Creates a constant slot with a value; returns the value.",
      needs = Permission.CHANGE)
  static UrbiObject setConstSlot(Frame frame, UrbiObject self, String name, UrbiObject value) {
    SlotUpdate.create(frame, self, symbol(self, name), value);
    SlotUpdate.setConstant(self, symbol(self, name), frame.interpreter().values().trueObject, true);
    return value;
  }

  @Builtin(
      doc = "Sets a slot; a value that it had is kept in a slot named name$old.",
      needs = Permission.CHANGE)
  static UrbiObject overrideSlot(Frame frame, UrbiObject self, String name, UrbiObject value) {
    UrbiObject old = self.lookup(symbol(self, name));
    if (old != null) {
      replace(self, symbol(self, name + "$old"), TakenCode.by(frame, old));
    }
    replace(self, symbol(self, name), TakenCode.by(frame, value));
    return value;
  }

  private static void replace(UrbiObject self, Symbol name, UrbiObject value) {
    self.removeSlot(name);
    self.addSlot(name, value);
  }

  @Builtin(doc = "Creates a slot whose value is void.", needs = Permission.CHANGE)
  static UrbiObject createSlot(Frame frame, UrbiObject self, String name) {
    UrbiObject nothing = frame.interpreter().values().voidObject;
    SlotUpdate.create(frame, self, symbol(self, name), nothing);
    return nothing;
  }

  @Builtin(
      value = {"updateSlot", "updateSlotValue"},
      doc = "Assigns a slot; an inherited one is created in the object itself.")
  static UrbiObject updateSlot(Frame frame, UrbiObject self, String name, UrbiObject value) {
    SlotUpdate.assign(frame, self, symbol(self, name), value);
    return value;
  }

  @Builtin(
      doc = "Removes the object's own slot; warns if there is none.",
      needs = Permission.CHANGE)
  static UrbiObject removeSlot(Frame frame, CallSite site, UrbiObject self, String name) {
    if (!self.removeSlot(symbol(self, name))) {
      Warnings.inside(frame, site, Problem.NO_LOCAL_SLOT, name);
    }
    return self;
  }

  @Builtin(doc = "Removes the object's own slot.", needs = Permission.CHANGE)
  static UrbiObject removeLocalSlot(Frame frame, UrbiObject self, String name) {
    if (!self.removeSlot(symbol(self, name))) {
      throw frame.interpreter().errors().lookup(self, name);
    }
    return self;
  }

  @Builtin(
      value = {"hasLocalSlot", "ownsSlot"},
      doc = "Whether the object itself has the slot.")
  static boolean hasLocalSlot(UrbiObject self, String name) {
    return self.hasLocalSlot(symbol(self, name));
  }

  @Builtin(doc = "Whether the object has the slot, its own or inherited.")
  static boolean hasSlot(UrbiObject self, String name) {
    self.noteStructureRead();
    return self.locate(symbol(self, name)) != null;
  }

  @Builtin(doc = "The object where the slot is found, nil if there is none.")
  static UrbiObject locateSlot(UrbiObject self, String name) {
    UrbiObject holder = self.locate(symbol(self, name));
    return holder == null ? self.world().values().nil : holder;
  }

  @Builtin(doc = "The names of the object's own slots, in alphabetical order.")
  static List<UrbiObject> localSlotNames(Frame frame, UrbiObject self) {
    Set<String> names = new TreeSet<>();
    addNames(frame, self, names);
    return strings(frame, names);
  }

  @Builtin(
      value = {"slotNames", "allSlotNames"},
      doc = "The names of all slots, also the inherited ones, in alphabetical order.")
  static List<UrbiObject> slotNames(Frame frame, UrbiObject self) {
    Set<String> names = new TreeSet<>();
    for (UrbiObject ancestor : ObjectType.allProtos(self)) {
      addNames(frame, ancestor, names);
    }
    return strings(frame, names);
  }

  private static void addNames(Frame frame, UrbiObject object, Set<String> names) {
    for (Symbol name : object.localSlotNames()) {
      frame.job().worked(Steps.OBJECT + Steps.ofCharacters(name.name().length()));
      names.add(name.name());
    }
  }

  private static List<UrbiObject> strings(Frame frame, Set<String> names) {
    List<UrbiObject> strings = new ArrayList<>(names.size());
    for (String name : names) {
      frame.job().worked(1);
      strings.add(frame.interpreter().values().string(name));
    }
    return strings;
  }

  @Builtin(
      doc = "Copies a slot of this object to a new one with the same value.",
      needs = Permission.CHANGE)
  static UrbiObject copySlot(Frame frame, UrbiObject self, String from, String to) {
    UrbiObject value = getSlot(frame, self, from);
    SlotUpdate.create(frame, self, symbol(self, to), value);
    return value;
  }

  @Builtin(
      doc = "Copies a slot of this object to a new one with a clone of the value.",
      needs = Permission.CHANGE)
  static UrbiObject cloneSlot(Frame frame, UrbiObject self, String from, String to) {
    UrbiObject value = frame.interpreter().send(frame, getSlot(frame, self, from), "clone");
    SlotUpdate.create(frame, self, symbol(self, to), value);
    return value;
  }

  // ------------------------------------------------------------------ properties

  @Builtin(doc = "The value of a property of a slot.")
  static UrbiObject getProperty(Frame frame, UrbiObject self, String slot, String property) {
    UrbiObject value = Properties.find(frame, self, symbol(self, slot), property);
    if (value == null) {
      throw frame.interpreter().errors().property(self, slot, property);
    }
    return value;
  }

  @Builtin(doc = "Sets a property of a slot.")
  static UrbiObject setProperty(
      Frame frame, UrbiObject self, String slot, String property, UrbiObject value) {
    Properties.set(frame, self, symbol(self, slot), property, value);
    return value;
  }

  @Builtin(doc = "Whether a slot has that property.")
  static boolean hasProperty(Frame frame, UrbiObject self, String slot, String property) {
    UrbiObject holder = found(frame, self, slot, self.locate(symbol(self, slot)));
    SlotData data = holder.slotData(symbol(self, slot));
    return data != null && data.properties().containsKey(property);
  }

  @Builtin(doc = "Removes a property of a slot; returns the value that it had, or warns.")
  static UrbiObject removeProperty(
      Frame frame, CallSite site, UrbiObject self, String slot, String property) {
    UrbiObject removed = Properties.remove(frame, self, symbol(self, slot), property);
    if (removed == null) {
      Warnings.inside(frame, site, Problem.NO_PROPERTY, slot, property);
      return frame.interpreter().values().voidObject;
    }
    return removed;
  }

  @Builtin(doc = "All the properties of a slot, as a Dictionary.")
  static UrbiObject properties(Frame frame, UrbiObject self, String slot) {
    UrbiObject holder = found(frame, self, slot, self.locate(symbol(self, slot)));
    SlotData data = holder.slotData(symbol(self, slot));
    Map<UrbiDictionary.Key, UrbiObject> all = new LinkedHashMap<>();
    if (data != null) {
      data.properties()
          .forEach((name, value) -> {
            UrbiString key = self.world().values().string(name);
            all.put(DictionaryKey.of(frame, key), TakenCode.by(frame, value));
          });
    }
    all.putIfAbsent(
        DictionaryKey.of(frame, self.world().values().string("constant")),
        self.world().values().falseObject);
    return self.world().values().dictionary(all);
  }
}

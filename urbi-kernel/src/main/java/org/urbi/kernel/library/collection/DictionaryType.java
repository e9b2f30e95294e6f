package org.urbi.kernel.library.collection;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.library.value.Comparison;
import org.urbi.kernel.library.value.Hashing;
import org.urbi.kernel.library.value.Printing;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;

/** Dictionaries (manual, "Dictionary"). */
@UrbiType(
    value = "Dictionary",
    protos = {"Comparable", "Container", "Object", "RangeIterable"},
    doc = "An associative array: values by keys, which may be any objects.",
    needs = Permission.NOTHING)
final class DictionaryType {
  private static final String ADDED = "elementAdded";
  private static final String CHANGED = "elementChanged";
  private static final String REMOVED = "elementRemoved";

  private DictionaryType() {}

  private static Values values(Frame caller) {
    return caller.interpreter().world().values();
  }

  // ------------------------------------------------------------------ what it is

  @Builtin(doc = "Adds the arguments, keys and values in turns.", needs = Permission.CHANGE)
  static UrbiObject init(
      Frame caller, CallSite site, UrbiDictionary self, UrbiObject... keysAndValues) {
    if (keysAndValues.length % 2 != 0) {
      throw caller.error(site, Problem.ODD_ARGUMENTS);
    }
    for (int i = 0; i < keysAndValues.length; i += 2) {
      set(caller, self, keysAndValues[i], keysAndValues[i + 1]);
    }
    return self;
  }

  @Builtin(doc = "Whether it is not empty.")
  static boolean asBool(UrbiDictionary self) {
    return !self.entries().isEmpty();
  }

  @Builtin(doc = "Whether it has no entries.")
  static boolean empty(UrbiDictionary self) {
    return self.entries().isEmpty();
  }

  @Builtin(doc = "The number of entries.")
  static int size(UrbiDictionary self) {
    return self.entries().size();
  }

  @Builtin(doc = "The entries, as asPrintable shows them.")
  static String asString(Frame caller, UrbiDictionary self) {
    return Printing.container(caller, self);
  }

  @Builtin(doc = "The list of the entries, as Pairs of a key and a value.")
  static List<UrbiObject> asList(Frame caller, UrbiDictionary self) {
    Shape pair = caller.interpreter().world().prototype("Pair").cloneShape();
    List<UrbiObject> pairs = new ArrayList<>();
    Symbol first = pair.world().symbol("first");
    Symbol second = pair.world().symbol("second");
    for (Map.Entry<UrbiDictionary.Key, UrbiObject> entry : self.sorted()) {
      caller.job().worked(Steps.OBJECT);
      UrbiObject both = new UrbiObject(pair);
      both.addSlot(first, entry.getKey().value());
      both.addSlot(second, entry.getValue());
      pairs.add(both);
    }
    return pairs;
  }

  @Builtin(doc = "The list of the keys.")
  static List<UrbiObject> keys(Frame caller, UrbiDictionary self) {
    List<UrbiObject> keys = new ArrayList<>();
    for (Map.Entry<UrbiDictionary.Key, UrbiObject> entry : self.sorted()) {
      caller.job().worked(1);
      keys.add(entry.getKey().value());
    }
    return keys;
  }

  @Builtin(doc = "A Hash, equal for equal dictionaries.")
  static UrbiHash hash(Frame caller, UrbiDictionary self) {
    long code = 5;
    for (var entry : self.snapshot()) {
      // The order of the entries makes no difference.
      code +=
          UrbiHash.mix(
              Hashing.code(caller, entry.getKey().value()), Hashing.code(caller, entry.getValue()));
    }
    return Hashing.hash(caller, code);
  }

  @Builtin(value = "==", doc = "Whether that is a dictionary with equal entries.")
  static boolean equals(Frame caller, UrbiDictionary self, UrbiObject that) {
    if (self == that) {
      return true;
    }
    if (!(that instanceof UrbiDictionary other)
        || self.entries().size() != other.entries().size()) {
      return false;
    }
    for (var entry : self.snapshot()) {
      caller.job().worked(1);
      UrbiObject value = other.entries().get(entry.getKey());
      if (value == null || !Comparison.equal(caller, entry.getValue(), value)) {
        return false;
      }
    }
    return true;
  }

  // ------------------------------------------------------------------ entries

  @Builtin(
      value = {"get", "[]"},
      doc = "The value of a key, which must be there.")
  static UrbiObject get(Frame caller, UrbiDictionary self, UrbiObject key) {
    UrbiObject value = self.entries().get(DictionaryKey.of(caller, key));
    if (value == null) {
      throw missing(caller, key);
    }
    return value;
  }

  private static UrbiException missing(Frame caller, UrbiObject key) {
    String shown = caller.interpreter().asString(caller, key);
    return caller.interpreter().errors().of(Problem.MISSING_KEY, shown).with("key", key).build();
  }

  @Builtin(doc = "The value of a key; the default value if it is not there.")
  static UrbiObject getWithDefault(
      Frame caller, UrbiDictionary self, UrbiObject key, UrbiObject defaultValue) {
    UrbiObject value = self.entries().get(DictionaryKey.of(caller, key));
    return value == null ? defaultValue : value;
  }

  @Builtin(doc = "Whether there is a value for a key.")
  static boolean has(Frame caller, UrbiDictionary self, UrbiObject key) {
    return self.entries().containsKey(DictionaryKey.of(caller, key));
  }

  @Builtin(doc = "Sets the value of a key; returns the target.", needs = Permission.CHANGE)
  static UrbiObject set(Frame caller, UrbiDictionary self, UrbiObject key, UrbiObject value) {
    UrbiDictionary.Key found = DictionaryKey.of(caller, key);
    caller.job().worked(Steps.OBJECT);
    UrbiObject before = self.modify().put(found, value);
    self.noteContentChange();
    emit(caller, self, before == null ? ADDED : CHANGED);
    return self;
  }

  @Builtin(
      value = "[]=",
      doc = "Sets the value of a key; returns the value.",
      needs = Permission.CHANGE)
  static UrbiObject setAt(Frame caller, UrbiDictionary self, UrbiObject key, UrbiObject value) {
    set(caller, self, key, value);
    return value;
  }

  @Builtin(
      doc = "Adds the entries of another dictionary; returns the target.",
      needs = Permission.CHANGE)
  static UrbiObject extend(Frame caller, UrbiDictionary self, UrbiDictionary other) {
    for (var entry : other.snapshot()) {
      set(caller, self, entry.getKey().value(), entry.getValue());
    }
    return self;
  }

  @Builtin(
      doc = "Removes the entry of a key, which must be there; returns the target.",
      needs = Permission.CHANGE)
  static UrbiObject erase(Frame caller, UrbiDictionary self, UrbiObject key) {
    if (self.modify().remove(DictionaryKey.of(caller, key)) == null) {
      throw missing(caller, key);
    }
    self.noteContentChange();
    emit(caller, self, REMOVED);
    return self;
  }

  @Builtin(doc = "Removes all entries; returns the target.", needs = Permission.CHANGE)
  static UrbiObject clear(Frame caller, UrbiDictionary self) {
    if (!self.modify().isEmpty()) {
      self.modify().clear();
      self.noteContentChange();
      emit(caller, self, REMOVED);
    }
    return self;
  }

  @Builtin(doc = "Whether the entries of a pattern are there and match, by the match of handler.")
  static boolean matchAgainst(
      Frame caller, UrbiDictionary self, UrbiObject handler, UrbiObject pattern) {
    if (!(pattern instanceof UrbiDictionary other)) {
      return false;
    }
    for (Map.Entry<UrbiDictionary.Key, UrbiObject> entry : other.snapshot()) {
      UrbiObject value = self.entries().get(entry.getKey());
      if (value == null || !ListSearch.matches(caller, handler, entry.getValue(), value)) {
        return false;
      }
    }
    return true;
  }

  // ------------------------------------------------------------------ events

  @Builtin(value = ADDED, doc = "An event emitted each time an entry is added.")
  static UrbiObject elementAdded(Frame caller, UrbiDictionary self) {
    return event(caller, self, ADDED);
  }

  @Builtin(value = CHANGED, doc = "An event emitted each time the value of a key is changed.")
  static UrbiObject elementChanged(Frame caller, UrbiDictionary self) {
    return event(caller, self, CHANGED);
  }

  @Builtin(value = REMOVED, doc = "An event emitted each time entries are removed.")
  static UrbiObject elementRemoved(Frame caller, UrbiDictionary self) {
    return event(caller, self, REMOVED);
  }

  /**
   * The event, which takes the place of the function that makes it. It belongs to whom the
   * dictionary belongs to, whoever asks for it first.
   */
  private static UrbiObject event(Frame caller, UrbiDictionary self, String slot) {
    Symbol name = caller.interpreter().world().symbol(slot);
    UrbiObject known = self.localSlot(name);
    if (known instanceof UrbiEvent) {
      return known;
    }
    UrbiObject event = caller.interpreter().prototypes().event.cloned();
    event.takeOwnerOf(self);
    if (known == null) {
      self.addSlot(name, event);
    }
    // Otherwise it has a function of that name, as the prototype has: nothing emits the event.
    return event;
  }

  private static void emit(Frame caller, UrbiDictionary self, String slot) {
    if (self.shape() == values(caller).dictionaryProto.cloneShape()) {
      // Without slots of its own it has no events.
      return;
    }
    Symbol name = caller.interpreter().world().symbol(slot);
    UrbiObject event = self.lookup(name);
    if (event != null && !(event instanceof Code)) {
      caller.interpreter().send(caller, event, "emit");
    }
  }
}

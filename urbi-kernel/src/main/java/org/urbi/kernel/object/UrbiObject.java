package org.urbi.kernel.object;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * An urbiscript object: slots, and prototypes to inherit slots from (manual, "Objects" and
 * "Object").
 *
 * <p>Lookup is depth first, through the prototypes in their order; the last one added comes first.
 * Only the kernel thread touches objects.
 */
public class UrbiObject {
  private static final UrbiObject[] NO_SLOTS = {};
  private static final String CONTENT = "(the content of a container)";

  /**
   * Stands for a missing number: of those that are not a number the one with these bits, which no
   * computation results in.
   */
  public static final double NO_NUMBER = Double.longBitsToDouble(0x7ff8_7572_6269_0001L);

  Shape shape;

  /** Null as long as the object has no slots of its own, as most numbers, which stay small. */
  private @Nullable Storage storage;

  /** The data of an object with slots of its own. */
  private static final class Storage {
    UrbiObject[] slots = NO_SLOTS;
    @Nullable Extra extra;
  }

  /** Data that only few objects need. */
  private static final class Extra {
    long uid;
    @Nullable Shape cloneShape;
    boolean inherited;

    /** Itself and its ancestors, when they have been looked for as those of a prototype. */
    Ancestors.@Nullable Known ancestors;

    @Nullable Map<Symbol, SlotData> slotData;
    @Nullable Dependencies structure;
    @Nullable Dependencies content;
    @Nullable UrbiObject ownerLobby;
    @Nullable Companion companion;
  }

  /**
   * What somebody knows about an object and what may itself refer to the object: only the object
   * keeps it, so that both can be garbage together.
   */
  public interface Companion {}

  /** An object of that shape, whose slots are all unset: use a shape without slots. */
  public UrbiObject(Shape shape) {
    this.shape = shape;
  }

  // ------------------------------------------------------------------ identity

  public final Shape shape() {
    return shape;
  }

  public final World world() {
    return shape.world;
  }

  /** The identifier, unique in this kernel. */
  public final long uid() {
    Extra x = extra();
    if (x.uid == 0) {
      x.uid = shape.world.nextUid();
    }
    return x.uid;
  }

  private Storage storage() {
    Storage s = storage;
    if (s == null) {
      s = new Storage();
      storage = s;
    }
    return s;
  }

  /** The storage of an object that has a slot. */
  // No null check, for the speed of each slot access: an index of a slot exists only for an object
  // that has one.
  @SuppressWarnings("NullAway")
  private Storage present() {
    return storage;
  }

  private Extra extra() {
    Storage s = storage();
    if (s.extra == null) {
      s.extra = new Extra();
    }
    return s.extra;
  }

  private @Nullable Extra extraOrNull() {
    return storage == null ? null : storage.extra;
  }

  /**
   * A new object whose only prototype is this one. Objects that hold a Java value (numbers, lists…)
   * override it: their clones hold a copy of the value.
   */
  public UrbiObject cloned() {
    return new UrbiObject(cloneShape());
  }

  /** A new object whose only prototype is this one, and which has these slots from the start. */
  public final UrbiObject clonedWith(SlotNames names, UrbiObject... values) {
    UrbiObject made = new UrbiObject(names.in(cloneShape()));
    made.storage().slots = values;
    return made;
  }

  /** The shape of a new clone of this object. */
  public final Shape cloneShape() {
    Extra x = extra();
    if (x.cloneShape == null) {
      x.cloneShape = Shape.root(shape.world, new UrbiObject[] {this});
      x.inherited = true;
    }
    return x.cloneShape;
  }

  // ------------------------------------------------------------------ slots

  /** The value of the slot at an index that {@link Shape#indexOf} gave. */
  public final UrbiObject slotAt(int index) {
    return seen(present().slots[index]);
  }

  /** From now on a number in a slot is an object like any other. */
  private static UrbiObject seen(UrbiObject value) {
    if (value instanceof UrbiFloat) {
      Shape whenSeen = value.shape.whenSeen;
      if (whenSeen != null) {
        value.shape = whenSeen;
      }
    }
    return value;
  }

  /**
   * The plain number in a slot of an object of that shape, without its object; {@link #NO_NUMBER}
   * if there is none.
   */
  public final double numberAt(Shape expected, int index) {
    return shape == expected
            && present().slots[index] instanceof UrbiFloat number
            && number.isPlain()
        ? number.value()
        : NO_NUMBER;
  }

  /**
   * Sets a slot, which is not {@linkplain Shape#writeSpecial special}, to a number of which there
   * is no object; false if this object has another shape, or code stands there.
   */
  public final boolean setNumberAt(Shape expected, int index, double number, Shape unseen) {
    if (shape != expected) {
      return false;
    }
    UrbiObject[] slots = present().slots;
    UrbiObject old = slots[index];
    if (old instanceof UrbiFloat kept) {
      if (old.shape == unseen) {
        kept.become(number);
        return true;
      }
    } else if (old instanceof UrbiCode) {
      return false;
    }
    slots[index] = new UrbiFloat(unseen, number);
    return true;
  }

  /** Sets the slot at an index which is not {@linkplain Shape#writeSpecial special}. */
  public final void setSlotAt(int index, UrbiObject value) {
    UrbiObject[] slots = present().slots;
    if (slots[index] instanceof UrbiCode) {
      shape.nameAt(index).epoch++;
    }
    slots[index] = value;
  }

  public final boolean hasLocalSlot(Symbol name) {
    noteStructureRead();
    return shape.indexOf(name) >= 0;
  }

  /** The value of the object's own slot, or null. */
  public final @Nullable UrbiObject localSlot(Symbol name) {
    int i = shape.indexOf(name);
    return i < 0 ? null : slotAt(i);
  }

  /** The value of the object's own slot, which must exist. */
  public final UrbiObject existingSlot(Symbol name) {
    return slotAt(shape.indexOf(name));
  }

  /** The names of the object's own slots, in the order of their creation. */
  public final Symbol[] localSlotNames() {
    noteStructureRead();
    return shape.names();
  }

  /** The values of the object's own slots, in the order of their creation. */
  public final List<UrbiObject> localSlotValues() {
    List<UrbiObject> values = new ArrayList<>();
    for (int i = 0; i < shape.size(); i++) {
      UrbiObject value = present().slots[i];
      if (value != null) { // a table of slots has holes
        values.add(seen(value));
      }
    }
    return values;
  }

  /** The object where the lookup of a name ends: this one, a prototype, or null. */
  public final @Nullable UrbiObject locate(Symbol name) {
    UrbiObject at = this;
    // The usual case, one prototype each, needs no set of visited objects.
    for (int steps = 0; steps < 64; steps++) {
      if (at.shape.indexOf(name) >= 0) {
        return at;
      }
      UrbiObject[] protos = at.shape.protos;
      if (protos.length == 0) {
        return null;
      }
      if (protos.length > 1) {
        break;
      }
      at = protos[0];
    }
    return Ancestors.holder(at, name);
  }

  /** This prototype and its ancestors; null when they are many, or it is no prototype. */
  final @Nullable List<WeakReference<UrbiObject>> knownAncestors() {
    Extra x = extraOrNull();
    if (x == null || !x.inherited) {
      return null;
    }
    Ancestors.Known known = x.ancestors;
    if (known == null || known.epoch() != shape.world.protosEpoch) {
      known = Ancestors.find(this);
      x.ancestors = known;
    }
    return known == null ? null : known.objects();
  }

  /** The value that the lookup of a name finds, or null; getters are not called. */
  public final @Nullable UrbiObject lookup(Symbol name) {
    UrbiObject holder = locate(name);
    return holder == null ? null : holder.localSlot(name);
  }

  /** Adds a slot that is not there yet. */
  public final void addSlot(Symbol name, UrbiObject value) {
    Storage s = storage();
    int size = shape.size();
    if (size >= s.slots.length) {
      s.slots = Arrays.copyOf(s.slots, size < 4 ? 4 : size * 2);
    }
    s.slots[size] = value;
    shape = shape.with(name);
    slotsChanged(name);
  }

  /** Adds slots that are not there yet, all at once; their shape is that of this object alone. */
  public final void addSlots(Symbol[] names, UrbiObject[] values) {
    append(shape.withAll(names), names, values);
  }

  /** Adds slots at the end; the next shape has them, too. */
  final void append(Shape next, Symbol[] names, UrbiObject[] values) {
    Storage s = storage();
    int size = next.size() - values.length;
    if (next.size() > s.slots.length) {
      s.slots = Arrays.copyOf(s.slots, next.size());
    }
    System.arraycopy(values, 0, s.slots, size, values.length);
    shape = next;
    for (Symbol name : names) {
      slotsChanged(name);
    }
  }

  /** Removes the object's own slot; false when it has none of that name. */
  public final boolean removeSlot(Symbol name) {
    int i = shape.indexOf(name);
    if (i < 0) {
      return false;
    }
    SlotData data = slotData(name);
    takeOut(i);
    if (data != null) {
      forgetSlotData(name);
      data.remove();
    }
    slotsChanged(name);
    return true;
  }

  private void takeOut(int i) {
    Storage s = present();
    boolean inherited = isInherited();
    if (shape.leavesHoles()) {
      s.slots[i] = null;
      shape = shape.without(i);
      if (shape.isSparse()) {
        s.slots = compacted(shape, s.slots, inherited);
        shape = shape.compact();
      }
      return;
    }
    int last = shape.size() - 1;
    UrbiObject[] fewer = new UrbiObject[Math.max(last, 4)];
    System.arraycopy(s.slots, 0, fewer, 0, i);
    System.arraycopy(s.slots, i + 1, fewer, i, last - i);
    // The slots behind it have moved.
    for (int moved = i + 1; moved <= last && inherited; moved++) {
      shape.nameAt(moved).epoch++;
    }
    s.slots = fewer;
    shape = shape.without(i);
  }

  /**
   * The slots without the holes between them; cached lookups that found them here become invalid.
   */
  private static UrbiObject[] compacted(Shape shape, UrbiObject[] sparse, boolean inherited) {
    UrbiObject[] dense = new UrbiObject[shape.names().length];
    int next = 0;
    for (Symbol name : shape.names()) {
      dense[next++] = sparse[shape.indexOf(name)];
      if (inherited) {
        name.epoch++;
      }
    }
    return dense;
  }

  /** A slot of that name was added or removed. */
  private void slotsChanged(Symbol name) {
    Extra x = present().extra;
    if (x != null) {
      if (x.inherited) {
        name.epoch++;
      }
      noteStructureChange(x);
    }
  }

  /**
   * From now on the epochs of names tell of changes of slots here, as if others inherited from this
   * object.
   */
  public final void announceChanges() {
    extra().inherited = true;
  }

  /** Whether others have looked up slots here, or may have. */
  private boolean isInherited() {
    Extra x = extraOrNull();
    return x != null && x.inherited;
  }

  // ------------------------------------------------------------------ properties

  /** The data of the object's own slot, or null when it is plain. */
  public final @Nullable SlotData slotData(Symbol name) {
    Extra x = extraOrNull();
    return x == null || x.slotData == null ? null : x.slotData.get(name);
  }

  private void forgetSlotData(Symbol name) {
    Extra x = extraOrNull();
    if (x != null && x.slotData != null) {
      x.slotData.remove(name);
    }
  }

  /**
   * The data of the object's own slot, created if missing; call {@link #slotDataChanged}
   * afterwards.
   */
  public final SlotData ensureSlotData(Symbol name) {
    Extra x = extra();
    if (x.slotData == null) {
      x.slotData = new LinkedHashMap<>();
    }
    return x.slotData.computeIfAbsent(name, n -> new SlotData());
  }

  /** To be called when the data of a slot were created or changed. */
  public final void slotDataChanged(Symbol name) {
    int i = shape.indexOf(name);
    SlotData data = slotData(name);
    byte flags = data == null ? 0 : data.flags();
    if (i >= 0 && shape.flagsAt(i) != flags) {
      shape = shape.withFlags(i, flags);
      if (isInherited()) {
        name.epoch++;
      }
    }
  }

  // ------------------------------------------------------------------ prototypes

  /** The prototypes in lookup order; not to be modified. */
  public final UrbiObject[] protos() {
    noteStructureRead();
    return shape.protos;
  }

  public final void setProtos(UrbiObject... protos) {
    for (UrbiObject proto : protos) {
      proto.extra().inherited = true;
    }
    shape = shape.withProtos(protos.clone());
    Extra x = extraOrNull();
    if (x != null) {
      if (x.inherited) {
        shape.world.invalidateLookups();
      }
      noteStructureChange(x);
    }
  }

  /** Puts a prototype in front, unless it is there already. */
  public final void addProto(UrbiObject proto) {
    UrbiObject[] old = shape.protos;
    for (UrbiObject known : old) {
      if (known == proto) {
        return;
      }
    }
    UrbiObject[] more = new UrbiObject[old.length + 1];
    more[0] = proto;
    System.arraycopy(old, 0, more, 1, old.length);
    setProtos(more);
  }

  public final void removeProto(UrbiObject proto) {
    setProtos(Arrays.stream(shape.protos).filter(p -> p != proto).toArray(UrbiObject[]::new));
  }

  /** Whether that object is this one or among its ancestors. */
  public final boolean isA(UrbiObject ancestor) {
    if (this == ancestor) {
      return true;
    }
    // The usual case, one prototype each, needs no set of visited objects.
    UrbiObject at = this;
    for (int steps = 0; steps < 64; steps++) {
      UrbiObject[] protos = at.shape.protos;
      if (protos.length == 0) {
        return false;
      }
      if (protos.length > 1) {
        break;
      }
      at = protos[0];
      if (at == ancestor) {
        return true;
      }
    }
    return Ancestors.contain(at, ancestor);
  }

  // ------------------------------------------------------------------ who may change it

  /**
   * The owner, which alone may change the object: a lobby, or the prototype of all objects if the
   * system owns it; null if anybody may change it.
   */
  public @Nullable UrbiObject ownerLobby() {
    Extra x = extraOrNull();
    return x == null ? null : x.ownerLobby;
  }

  /** Sets the owner: a lobby, or the prototype of all objects for the system. */
  public final void setOwnerLobby(UrbiObject whose) {
    extra().ownerLobby = whose;
  }

  /** Gives it the owner of another object, if that has one. */
  public final void takeOwnerOf(UrbiObject other) {
    UrbiObject whose = other.ownerLobby();
    if (whose != null) {
      setOwnerLobby(whose);
    }
  }

  // ------------------------------------------------------------------ what it keeps for others

  /** What was set for it to keep; null if nothing was. */
  public final @Nullable Companion companion() {
    Extra x = extraOrNull();
    return x == null ? null : x.companion;
  }

  /** Sets what it keeps from now on. Clones do not inherit it. */
  public final void setCompanion(Companion kept) {
    extra().companion = kept;
  }

  // ------------------------------------------------------------------ dependency tracking

  /** The condition being evaluated, if any, depends on the value of the object's own slot. */
  public final void noteSlotRead(Symbol name) {
    if (shape.world.tracker != null) {
      SlotData data = ensureSlotData(name);
      Dependencies dependents = data.dependents();
      if (dependents == null) {
        dependents = new Dependencies(name.name());
        data.setDependents(dependents);
        slotDataChanged(name);
      }
      shape.world.tracker.read(dependents);
    }
  }

  /** The condition being evaluated, if any, depends on which slots and prototypes there are. */
  public final void noteStructureRead() {
    if (shape.world.tracker != null) {
      Extra x = extra();
      if (x.structure == null) {
        x.structure = new Dependencies("");
      }
      shape.world.tracker.read(x.structure);
    }
  }

  private static void noteStructureChange(Extra x) {
    if (x.structure != null) {
      x.structure.changed();
    }
  }

  /** The condition being evaluated, if any, depends on a slot that does not exist. */
  public final void noteAbsence() {
    if (shape.world.tracker != null) {
      Ancestors ancestors = new Ancestors(this);
      for (UrbiObject at = ancestors.next(); at != null; at = ancestors.next()) {
        at.noteStructureRead();
      }
    }
  }

  /** The condition being evaluated, if any, depends on the content of this container. */
  public final void noteContentRead() {
    if (shape.world.tracker != null) {
      shape.world.tracker.read(content());
    }
  }

  private Dependencies content() {
    Extra x = extra();
    if (x.content == null) {
      x.content = new Dependencies(CONTENT);
    }
    return x.content;
  }

  /** Adds a watcher that is called at each change of the content of this container. */
  public final void watchContent(Dependencies.Watcher watcher) {
    content().add(watcher);
  }

  /** Whether there may be somebody to be told when the content of this container changes. */
  public final boolean isContentWatched() {
    Extra x = extraOrNull();
    return x != null && x.content != null;
  }

  /** The content of this container has changed. */
  public final void noteContentChange() {
    if (isContentWatched()) {
      content().changed();
    }
  }
}

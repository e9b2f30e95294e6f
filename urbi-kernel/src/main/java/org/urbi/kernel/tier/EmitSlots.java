package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_boolean;
import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_void;

import java.lang.classfile.Label;
import java.lang.constant.MethodTypeDesc;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CompoundAssignment;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.SlotLookup;
import org.urbi.kernel.node.Slots;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiCode;
import org.urbi.kernel.object.UrbiObject;

/**
 * Emits how slots are found, read and assigned: first of all where they were found until now. What
 * that depends on, besides the shape of the target, is told by the epoch of the name.
 */
final class EmitSlots {
  /** For more shapes of targets the cache of the node is as good. */
  private static final int MOST_PLACES = 4;

  private static final MethodTypeDesc SHAPE = MethodTypeDesc.of(Names.SHAPE);
  private static final MethodTypeDesc SLOT_AT = MethodTypeDesc.of(Names.OBJECT, CD_int);
  private static final MethodTypeDesc SET_SLOT_AT =
      MethodTypeDesc.of(CD_void, CD_int, Names.OBJECT);

  /**
   * Where a slot was found.
   *
   * @param shape the shape of the target; null if it is one object
   * @param self that object
   * @param holder whose slot it is; null if the target itself has it
   */
  record Place(
      @Nullable Shape shape, @Nullable UrbiObject self, @Nullable UrbiObject holder, int index) {
    /** Whether the slot is one of the target itself, and is just set. */
    boolean isPlainlyOwn() {
      return self != null && holder == self && !self.shape().writeSpecial(index);
    }

    /** The code in the slot, which is the same as long as the epoch of its name is; or null. */
    @Nullable UrbiCode code() {
      return holder != null && holder.slotAt(index) instanceof UrbiCode code ? code : null;
    }
  }

  private final Emitter to;
  private final Unit unit;

  EmitSlots(Emitter to, Unit unit) {
    this.to = to;
    this.unit = unit;
  }

  // ------------------------------------------------------------------ where slots are

  /** Where the slots of a name are that was looked up in a target. */
  List<Place> places(SlotLookup lookup, @Nullable Node target) {
    List<Place> places = new ArrayList<>();
    if (isLobby(target)) {
      Place place = ofLobby(lookup.name());
      if (place != null) {
        places.add(place);
      }
      return places;
    }
    for (SlotLookup.Known known : lookup.known()) {
      if (places.size() < MOST_PLACES) {
        places.add(new Place(known.shape(), null, known.holder(), known.index()));
      }
    }
    return places;
  }

  /** Whether the target is a lobby: its shape changes with each variable of the top level. */
  private boolean isLobby(@Nullable Node target) {
    return (target == null || target instanceof Literals.This)
        && unit.frame().self() == unit.frame().job().lobby();
  }

  private @Nullable Place ofLobby(Symbol name) {
    UrbiObject lobby = unit.frame().self();
    UrbiObject holder = lobby.locate(name);
    if (holder == null || holder.shape().readSpecial(holder.shape().indexOf(name))) {
      return null;
    }
    lobby.announceChanges();
    lobby.world().remember(name);
    return new Place(null, lobby, holder, holder.shape().indexOf(name));
  }

  /** Emits what must hold for all of these places; jumps otherwise. */
  void guard(Symbol name, Label otherwise) {
    to.doubt(otherwise);
    to.constant(unit.frame().self().world(), Names.WORLD);
    to.code.getfield(Names.WORLD, "tracker", Names.TRACKER).ifnonnull(otherwise);
    epoch(name, otherwise);
  }

  private void epoch(Symbol name, Label otherwise) {
    to.constant(name, Names.SYMBOL);
    to.code
        .invokevirtual(Names.SYMBOL, "epoch", MethodTypeDesc.of(CD_int))
        .loadConstant(name.epoch())
        .if_icmpne(otherwise);
  }

  /** Jumps unless the slot of the target is there. */
  void check(Place place, int target, Label otherwise) {
    to.code.aload(target);
    if (place.shape() != null) {
      to.code.invokevirtual(Names.OBJECT, "shape", SHAPE);
      to.constant(place.shape(), Names.SHAPE);
    } else if (place.self() != null) {
      to.constant(place.self(), Names.OBJECT);
    }
    to.code.if_acmpne(otherwise);
  }

  /** Pushes the value of the slot there. */
  void read(Place place, int target) {
    UrbiCode code = place.code();
    if (code != null) {
      to.constant(code, Names.OBJECT);
      return;
    }
    if (place.holder() == null) {
      to.code.aload(target);
    } else {
      to.constant(place.holder(), Names.OBJECT);
    }
    to.code.loadConstant(place.index()).invokevirtual(Names.OBJECT, "slotAt", SLOT_AT);
  }

  /** Counts that something was not as expected. */
  void missed() {
    to.constant(unit.misses(), Names.MISSES);
    to.code.invokevirtual(Names.MISSES, "add", MethodTypeDesc.of(CD_void));
  }

  // ------------------------------------------------------------------ assignments

  Value value(Slots.Assign assignment) {
    int target = to.newObject();
    to.load(to.operand(assignment.target()));
    to.code.astore(target);
    Value value = to.operand(assignment.value());
    if (value.hasObject()) {
      to.located(assignment, () -> to.notVoid(value));
    }
    return assign(assignment, target, value);
  }

  Value value(Slots.Declare declaration) {
    to.load(to.operand(declaration.target()));
    Value target = to.storedObject();
    Node initial = declaration.value();
    Value value = initial == null ? to.voidValue() : to.operand(initial);
    if (initial != null && value.hasObject()) {
      to.located(declaration.named(), () -> to.notVoid(value));
    }
    to.load(value);
    Value result = to.storedObject();
    to.code.aload(target.object()).aload(result.object());
    to.frame();
    to.constant(declaration, Names.SLOT_DECLARATION);
    to.help("declare", CD_void, Names.OBJECT, Names.OBJECT, Names.FRAME, Names.SLOT_DECLARATION);
    to.afterOthers();
    return result;
  }

  private Value assign(Slots.Assign assignment, int target, Value value) {
    Label slow = to.code.newLabel();
    Label over = to.code.newLabel();
    to.load(value);
    Value result = to.storedObject();
    Shape shape = assignment.knownShape();
    Place place = isLobby(assignment.target()) ? ofLobby(assignment.name()) : null;
    if (place != null && place.isPlainlyOwn()) {
      to.doubt(slow);
      epoch(assignment.name(), slow);
      check(place, target, slow);
      set(place.index(), target, result, slow, over);
    } else if (shape != null) {
      to.doubt(slow);
      check(new Place(shape, null, null, 0), target, slow);
      set(assignment.knownIndex(), target, result, slow, over);
    }
    to.code.labelBinding(slow);
    if (place != null || shape != null) {
      missed();
    }
    to.code.aload(target).aload(result.object());
    to.frame();
    to.constant(assignment, Names.SLOT_ASSIGNMENT);
    to.help("assign", Names.OBJECT, Names.OBJECT, Names.OBJECT, Names.FRAME, Names.SLOT_ASSIGNMENT);
    to.code.astore(result.object());
    to.afterOthers();
    to.code.labelBinding(over);
    return result;
  }

  private void set(int index, int target, Value value, Label slow, Label over) {
    to.frame();
    to.help("isOwner", CD_boolean, Names.FRAME);
    to.code.ifeq(slow);
    to.code.aload(target).loadConstant(index).aload(value.object());
    to.code.invokevirtual(Names.OBJECT, "setSlotAt", SET_SLOT_AT).goto_(over);
  }

  /** {@code a.x += b}, {@code a.x++}. */
  Value value(CompoundAssignment assignment, CompoundAssignment.Slot slot) {
    int target = to.newObject();
    Value[] results = new Value[1];
    to.located(
        assignment,
        () -> {
          to.load(to.operand(slot.target()));
          to.code.astore(target);
          Value before = before(assignment, slot, target);
          Value after = to.arithmetic().combined(assignment, before);
          Value written = assign(slot.writer(), target, after);
          results[0] = assignment.operand() == null ? before : written;
        });
    return results[0];
  }

  private Value before(CompoundAssignment assignment, CompoundAssignment.Slot slot, int target) {
    Label slow = to.code.newLabel();
    Label over = to.code.newLabel();
    Value before = Value.ofObject(to.newObject());
    List<Place> places = places(slot.lookup(), slot.target());
    if (!places.isEmpty()) {
      guard(slot.lookup().name(), slow);
      for (Place place : places) {
        Label next = to.code.newLabel();
        check(place, target, next);
        read(place, target);
        to.code.dup().astore(before.object());
        to.code.instanceOf(Names.CODE).ifeq(over);
        to.code.labelBinding(next);
      }
    }
    to.code.labelBinding(slow);
    if (!places.isEmpty()) {
      missed();
    }
    to.code.aload(target);
    to.frame();
    to.constant(assignment, Names.COUNTING);
    to.help("before", Names.OBJECT, Names.OBJECT, Names.FRAME, Names.COUNTING);
    to.code.astore(before.object());
    to.afterOthers();
    to.code.labelBinding(over);
    return before;
  }
}

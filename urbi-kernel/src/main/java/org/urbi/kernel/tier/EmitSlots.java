package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_boolean;
import static java.lang.constant.ConstantDescs.CD_double;
import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_long;
import static java.lang.constant.ConstantDescs.CD_void;

import java.lang.classfile.Label;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CompoundAssignment;
import org.urbi.kernel.node.KnownSlot;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.SlotLookup;
import org.urbi.kernel.node.Slots;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiCode;
import org.urbi.kernel.object.UrbiObject;

/**
 * Emits how slots are found, read and assigned: first of all where they were found until now. What
 * that depends on, besides the shape of the target, is told by the epoch of the name.
 */
final class EmitSlots {
  private static final MethodTypeDesc IS_OF = MethodTypeDesc.of(CD_boolean, Names.OBJECT);
  private static final MethodTypeDesc READ = MethodTypeDesc.of(Names.OBJECT, Names.OBJECT);
  private static final MethodTypeDesc SET =
      MethodTypeDesc.of(CD_boolean, Names.OBJECT, Names.OBJECT, Names.JOB);

  private static final MethodTypeDesc NUMBER = MethodTypeDesc.of(CD_double, Names.SHAPE, CD_int);
  private static final MethodTypeDesc BITS = MethodTypeDesc.of(CD_long, CD_double);
  private static final long NO_NUMBER = Double.doubleToRawLongBits(UrbiObject.NO_NUMBER);
  private static final MethodTypeDesc SET_NUMBER =
      MethodTypeDesc.of(CD_boolean, Names.SHAPE, CD_int, CD_double, Names.SHAPE);

  private final Emitter to;
  private final KnownPlaces places;
  private final Unit unit;

  EmitSlots(Emitter to, Unit unit) {
    this.to = to;
    this.places = new KnownPlaces(unit);
    this.unit = unit;
  }

  /** Where the slots of a name are that was looked up in a target. */
  List<KnownSlot> places(SlotLookup lookup, @Nullable Node target) {
    return places.of(lookup, target);
  }

  private void place(KnownSlot place, int target) {
    to.constant(place, Names.KNOWN_SLOT);
    to.code.aload(target);
  }

  /** Jumps unless the slot of the target is there. */
  void check(KnownSlot place, int target, Label otherwise) {
    to.doubt(otherwise);
    place(place, target);
    to.code.invokevirtual(Names.KNOWN_SLOT, "isOf", IS_OF).ifeq(otherwise);
  }

  /** Pushes the value of the slot there, which has been checked. */
  void read(KnownSlot place, int target) {
    UrbiCode code = place.code();
    if (code == null) {
      place(place, target);
      to.code.invokevirtual(Names.KNOWN_SLOT, "read", READ);
    } else {
      to.constant(code, Names.OBJECT);
    }
  }

  /** Stores the value of a slot of the target itself; jumps if it is not there. */
  void readOwn(KnownSlot place, int target, int value, Label otherwise) {
    check(place, target, otherwise);
    read(place, target);
    to.code.astore(value);
  }

  /** If the slot is there and its value is no code, stores the value and jumps. */
  void plainValue(KnownSlot place, int target, int value, Label found) {
    Label otherwise = to.code.newLabel();
    to.doubt(otherwise);
    place(place, target);
    to.code
        .invokevirtual(Names.KNOWN_SLOT, "plainValue", READ)
        .dup()
        .astore(value)
        .ifnonnull(found);
    to.code.labelBinding(otherwise);
  }

  /**
   * Jumps unless the slot is there, and has a plain number.
   *
   * @return the slot of its double
   */
  int plainNumber(KnownSlot place, int target, Label otherwise) {
    Value value = Value.ofObject(to.newObject());
    if (place.ownShape() != null) {
      return unseenNumber(place.ownShape(), place.index(), target, otherwise);
    }
    place(place, target);
    to.code
        .invokevirtual(Names.KNOWN_SLOT, "plainValue", READ)
        .dup()
        .astore(value.object())
        .ifnull(otherwise);
    return to.number(value, otherwise);
  }

  /** Reads the number in a slot of the target itself, without making an object of it. */
  private int unseenNumber(Shape shape, int index, int target, Label otherwise) {
    to.doubt(otherwise);
    to.code.aload(target);
    to.constant(shape, Names.SHAPE);
    to.code.loadConstant(index).invokevirtual(Names.OBJECT, "numberAt", NUMBER);
    int number = to.storedNumber().number();
    compareWithMissing(number);
    to.code.ifeq(otherwise);
    return number;
  }

  /** Jumps unless it is what stands for a missing number. */
  void unlessMissing(int number, Label otherwise) {
    compareWithMissing(number);
    to.code.ifne(otherwise);
  }

  private void compareWithMissing(int number) {
    to.code
        .dload(number)
        .invokestatic(ConstantDescs.CD_Double, "doubleToRawLongBits", BITS)
        .loadConstant(NO_NUMBER)
        .lcmp();
  }

  /** Jumps if somebody collects what is read. */
  void untracked(Label otherwise) {
    to.constant(to.values.object.world(), Names.WORLD);
    to.code.getfield(Names.WORLD, "tracker", Names.TRACKER).ifnonnull(otherwise);
  }

  /** Sets a slot to a number of which there is no object; jumps if it has not done so. */
  void setNumber(Shape shape, int index, int target, int number, Label otherwise) {
    to.doubt(otherwise);
    to.job();
    to.code.invokevirtual(Names.JOB, "isOwner", MethodTypeDesc.of(CD_boolean));
    to.code.ifeq(otherwise).aload(target);
    to.constant(shape, Names.SHAPE);
    to.code.loadConstant(index).dload(number);
    to.constant(to.values.unseenShape, Names.SHAPE);
    to.code.invokevirtual(Names.OBJECT, "setNumberAt", SET_NUMBER).ifeq(otherwise);
  }

  /** Counts that something was not as expected. */
  void missed() {
    to.constant(unit.misses(), Names.MISSES);
    to.code.invokevirtual(Names.MISSES, "add", MethodTypeDesc.of(CD_void));
  }

  // ------------------------------------------------------------------ assignments

  Value value(Slots.Assign assignment) {
    int target = target(assignment.target());
    return assign(assignment, target, assigned(assignment));
  }

  private int target(Node node) {
    int target = to.newObject();
    to.load(to.operand(node));
    to.code.astore(target);
    return target;
  }

  private Value assigned(Slots.Assign assignment) {
    Value value = to.operand(assignment.value());
    if (value.hasObject()) {
      to.located(assignment, () -> to.notVoid(value));
    }
    return value;
  }

  /** An assignment whose value nobody uses: a number gets no object. */
  void effect(Slots.Assign assignment) {
    int target = target(assignment.target());
    Value value = assigned(assignment);
    Label over = to.code.newLabel();
    Shape shape = assignment.knownShape();
    if (shape != null && value.hasNumber() && !value.isVariable()) {
      Label otherwise = to.code.newLabel();
      if (value.hasObject()) {
        to.code.aload(value.object()).ifnonnull(otherwise);
      }
      setNumber(shape, assignment.knownIndex(), target, value.number(), otherwise);
      to.code.goto_(over);
      to.code.labelBinding(otherwise);
    }
    assign(assignment, target, value);
    to.code.labelBinding(over);
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
    KnownSlot place =
        places.isLobby(assignment.target()) ? places.ofLobby(assignment.name()) : null;
    if (place != null && place.isPlainlyOwn()) {
      set(place, target, result, slow, over);
    } else if (shape != null) {
      set(
          places.own(assignment.name(), shape, assignment.knownIndex()),
          target,
          result,
          slow,
          over);
    }
    to.code.labelBinding(slow);
    if (place != null || shape != null) {
      missed();
    }
    to.code.aload(target).aload(result.object());
    to.frame();
    to.constant(assignment, Names.SLOT_ASSIGNMENT);
    to.place();
    to.help(
        "assign",
        Names.OBJECT,
        Names.OBJECT,
        Names.OBJECT,
        Names.FRAME,
        Names.SLOT_ASSIGNMENT,
        Names.NODE);
    to.code.astore(result.object());
    to.afterOthers();
    to.code.labelBinding(over);
    return result;
  }

  private void set(KnownSlot place, int target, Value value, Label slow, Label over) {
    to.doubt(slow);
    place(place, target);
    to.code.aload(value.object());
    to.job();
    to.code.invokevirtual(Names.KNOWN_SLOT, "set", SET).ifne(over);
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
    Label over = to.code.newLabel();
    Value before = Value.ofObject(to.newObject());
    List<KnownSlot> places = places(slot.lookup(), slot.target());
    for (KnownSlot place : places) {
      plainValue(place, target, before.object(), over);
    }
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

package org.urbi.kernel.node;

import static java.util.Objects.requireNonNull;

import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** Writes slots: creation, assignment with copy on write, and the effects of properties. */
public final class SlotUpdate {
  private SlotUpdate() {}

  /**
   * The value of the {@code changed} property of a slot: an event, which this package only knows
   * how to emit.
   */
  public interface Signal {
    void emit(Frame frame, UrbiObject... payload);
  }

  /**
   * Marks a setter that does the whole assignment, including the notification of those who watch
   * the slot. What it returns is the value of the assignment.
   */
  public interface Whole {}

  /**
   * {@code setSlot}: creates a slot.
   *
   * @throws org.urbi.kernel.error.UrbiException when the object has it already
   */
  public static void create(Frame frame, UrbiObject target, Symbol name, UrbiObject value) {
    PermissionCheck.checkChange(frame, "setSlot", target);
    if (target.shape().indexOf(name) >= 0) {
      if (RedefinitionMode.allowed(frame.job) == 0) {
        throw frame.interpreter.errors().redefinition(name.name());
      }
      target.removeSlot(name);
    }
    target.addSlot(name, TakenCode.by(frame, value));
  }

  /**
   * {@code updateSlot}: assigns a slot; one that is inherited is created in the object itself.
   *
   * @return the value of the assignment: the given one, or what the slot's range or its {@code
   *     updateHook} has made of it
   * @throws org.urbi.kernel.error.UrbiException when there is no such slot, or it is constant
   */
  public static UrbiObject assign(Frame frame, UrbiObject target, Symbol name, UrbiObject given) {
    UrbiObject value = TakenCode.by(frame, given);
    Shape shape = target.shape();
    int index = shape.indexOf(name);
    if (index >= 0 || !(target instanceof SlotProxy)) {
      PermissionCheck.checkChange(frame, "updateSlot", target);
    }
    if (index >= 0) {
      if (shape.writeSpecial(index)) {
        return assignSpecial(frame, target, target, name, value);
      }
      target.setSlotAt(index, value);
      return value;
    }
    if (target instanceof SlotProxy proxy) {
      return proxy.updateSlot(frame, name, value);
    }
    UrbiObject holder = target.locate(name);
    if (holder == null) {
      assignMissing(frame, target, name, value);
      return value;
    }
    int inherited = holder.shape().indexOf(name);
    if (holder.shape().writeSpecial(inherited)) {
      SlotData data = special(holder, name);
      if (data.setter() != null) {
        return assignSpecial(frame, target, holder, name, value);
      }
      UrbiObject accepted = accepted(frame, target, name, data, value);
      if (target.shape().indexOf(name) >= 0) {
        // The hook has created the slot meanwhile.
        return assign(frame, target, name, accepted);
      }
      target.addSlot(name, accepted);
      return accepted;
    }
    target.addSlot(name, value);
    return value;
  }

  private static SlotData special(UrbiObject holder, Symbol name) {
    return requireNonNull(holder.slotData(name), "what is special about a slot is in its data");
  }

  /** The value after the slot's {@code updateHook} and its range have been applied. */
  private static UrbiObject accepted(
      Frame frame, UrbiObject target, Symbol name, SlotData data, UrbiObject given) {
    UrbiObject value = given;
    if (data.updateHook() != null) {
      var values = frame.interpreter.values();
      UrbiObject wanted =
          frame.interpreter.call(
              frame, data.updateHook(), target, values.string(name.name()), given);
      value = wanted == values.voidObject ? given : wanted;
    }
    if (value instanceof UrbiFloat number) {
      if (data.least() instanceof UrbiFloat least && number.value() < least.value()) {
        return least;
      }
      if (data.most() instanceof UrbiFloat most && number.value() > most.value()) {
        return most;
      }
    }
    return value;
  }

  /** Handles an assignment to a missing slot: an error, unless the object defines otherwise. */
  private static void assignMissing(Frame frame, UrbiObject target, Symbol name, UrbiObject value) {
    Symbol updateSlot = frame.interpreter.world().symbol("updateSlot");
    UrbiObject own = target.lookup(updateSlot);
    if (!(own instanceof Function)) {
      throw frame.interpreter.errors().lookup(target, name.name());
    }
    frame.interpreter.call(
        frame, own, target, frame.interpreter.values().string(name.name()), value);
  }

  private static UrbiObject assignSpecial(
      Frame frame, UrbiObject target, UrbiObject holder, Symbol name, UrbiObject given) {
    SlotData data = special(holder, name);
    if (data.isConstant()) {
      throw frame.interpreter.errors().constness();
    }
    // With a setter no range is applied: a UVar applies its own, and a program's setter gets all
    // values.
    UrbiObject value = data.setter() == null ? accepted(frame, target, name, data, given) : given;
    if (holder.slotData(name) != data) {
      // Its hook has replaced the slot.
      return assign(frame, target, name, value);
    }
    if (data.blending() instanceof Blending blending) {
      UrbiObject blended = blending.assigned(frame, value);
      if (blended == null) {
        return value;
      }
      if (holder.slotData(name) != data) {
        // The assignment has waited, and the slot has changed meanwhile.
        assign(frame, target, name, blended);
        return value;
      }
      write(frame, target, holder, name, data, blended);
      return value;
    }
    return write(frame, target, holder, name, data, value);
  }

  /** Writes, and returns the value of the assignment. */
  private static UrbiObject write(
      Frame frame,
      UrbiObject target,
      UrbiObject holder,
      Symbol name,
      SlotData data,
      UrbiObject value) {
    if (data.setter() != null) {
      UrbiObject written = frame.interpreter.call(frame, data.setter(), target, value);
      if (data.setter() instanceof Whole) {
        return written;
      }
    } else {
      holder.setSlotAt(holder.shape().indexOf(name), value);
    }
    if (data.dependents() != null) {
      data.dependents().changed();
    }
    if (data.changed() instanceof Signal signal) {
      signal.emit(frame, value);
    }
    return value;
  }

  /** Makes a slot constant, or assignable again. */
  public static void setConstant(UrbiObject target, Symbol name, UrbiObject flag, boolean on) {
    SlotData data = target.ensureSlotData(name);
    data.setConstant(on);
    data.setProperty("constant", flag);
    target.slotDataChanged(name);
  }
}

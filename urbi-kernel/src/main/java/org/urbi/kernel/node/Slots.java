package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Slots: declaration, assignment, access without a call. */
public final class Slots {
  private Slots() {}

  /** {@code var target.name = value}. */
  public static final class Declare extends Node {
    private final Node target;
    private final Symbol name;
    private final @Nullable Node value;
    private final boolean constant;
    private final @Nullable Node type;
    private final Span nameSpan;

    /**
     * @param nameSpan the location of the name alone
     * @param value null for void
     * @param type the required type, or null
     */
    public Declare(
        Span span,
        Span nameSpan,
        Node target,
        Symbol name,
        @Nullable Node value,
        boolean constant,
        @Nullable Node type) {
      super(span);
      this.nameSpan = nameSpan;
      this.target = target;
      this.name = name;
      this.value = value;
      this.constant = constant;
      this.type = type;
    }

    public Node target() {
      return target;
    }

    /** Null for void. */
    public @Nullable Node value() {
      return value;
    }

    /** Whether the slot is just created: neither constant, nor of a type. */
    public boolean isPlain() {
      return !constant && type == null;
    }

    /** Where errors are reported. */
    public Node named() {
      return new Sequences.Noop(nameSpan);
    }

    /** Creates the slot. */
    void create(Frame frame, UrbiObject object, UrbiObject initial) {
      try {
        SlotUpdate.create(frame, object, name, initial);
      } catch (UrbiException e) {
        throw frame.located(e, nameSpan);
      }
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject object = target.execute(frame);
      UrbiObject initial = Variables.initialValue(frame, value, nameSpan);
      try {
        if (type != null && value != null) {
          TypeCheck.check(frame, name.name(), 1, initial, type.execute(frame));
        }
        SlotUpdate.create(frame, object, name, initial);
        if (constant) {
          SlotUpdate.setConstant(object, name, frame.interpreter.values().trueObject, true);
        }
        return initial;
      } catch (UrbiException e) {
        throw frame.located(e, nameSpan);
      }
    }
  }

  /** {@code target.name = value}. */
  public static final class Assign extends Node {
    private final Node target;
    private final Symbol name;
    private final Node value;
    private final Span place;
    private @Nullable Shape knownShape;
    private int knownIndex;

    /**
     * @param place the location of the assigned expression, where errors are reported
     */
    public Assign(Span span, Span place, Node target, Symbol name, Node value) {
      super(span);
      this.place = place;
      this.target = target;
      this.name = name;
      this.value = value;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject object = target.execute(frame);
      UrbiObject assigned = ArgumentEvaluation.notVoid(frame, value, span());
      return assign(frame, object, assigned);
    }

    public Node target() {
      return target;
    }

    public Node value() {
      return value;
    }

    public Symbol name() {
      return name;
    }

    /** The shape of objects whose slot is just set, at an index; null if there was none. */
    public @Nullable Shape knownShape() {
      return knownShape;
    }

    /** The index of the slot in objects of that shape. */
    public int knownIndex() {
      return knownIndex;
    }

    /** Returns the value of the assignment. */
    UrbiObject assign(Frame frame, UrbiObject object, UrbiObject assigned) {
      if (object.shape() == knownShape
          && (frame.job.isOwner()
              || !(assigned instanceof Code) && PermissionCheck.allowsChange(frame.job, object))) {
        object.setSlotAt(knownIndex, assigned);
        return assigned;
      }
      UrbiObject given;
      try {
        if (object instanceof SlotProxy proxy && object.shape().indexOf(name) < 0) {
          return proxy.updateSlot(frame, name, assigned);
        }
        given = SlotUpdate.assign(frame, object, name, assigned);
      } catch (UrbiException e) {
        throw frame.located(e, place);
      }
      Shape shape = object.shape();
      int index = shape.indexOf(name);
      if (index >= 0 && !shape.writeSpecial(index)) {
        knownShape = shape;
        knownIndex = index;
      }
      return given;
    }
  }

  /** {@code target.&name}: the value of the slot, not called. */
  public static final class Access extends Node {
    private final Node target;
    private final SlotLookup lookup;

    public Access(Span span, Node target, SlotLookup lookup) {
      super(span);
      this.target = target;
      this.lookup = lookup;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject object = target.execute(frame);
      UrbiObject value = SlotLookup.findRaw(object, lookup.name());
      if (value == null) {
        throw frame.located(
            frame.interpreter.errors().lookup(object, lookup.name().name()), span());
      }
      return TakenCode.by(frame, value);
    }
  }

  /** Creates slot lookups for the compiler. */
  public static SlotLookup lookup(Interpreter interpreter, String name) {
    return new SlotLookup(interpreter.world(), interpreter.world().symbol(name));
  }
}

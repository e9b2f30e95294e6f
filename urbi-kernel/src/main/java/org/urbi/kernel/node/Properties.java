package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.BlendMode;
import org.urbi.kernel.object.SlotBlending;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Properties of slots (manual, "Properties"). */
public final class Properties {
  private Properties() {}

  // ------------------------------------------------------------------ what the library uses too

  /** The property, or null. */
  public static @Nullable UrbiObject find(
      Frame frame, UrbiObject target, Symbol slot, String property) {
    if (target instanceof SlotProxy proxy && target.shape().indexOf(slot) < 0) {
      return proxy.property(frame, slot, property);
    }
    UrbiObject holder = holder(frame, target, slot);
    if (property.equals("changed")) {
      return changed(frame, holder, slot);
    }
    SlotData data = holder.slotData(slot);
    if (data == null) {
      return null;
    }
    UrbiObject variable = holder.localSlot(slot);
    return property.equals("timestamp")
            && variable != null
            && data.getter() instanceof SlotUpdate.Whole
        ? frame.interpreter.send(frame, variable, property)
        : taken(frame, data.property(property));
  }

  private static @Nullable UrbiObject taken(Frame frame, @Nullable UrbiObject value) {
    return value == null ? null : TakenCode.by(frame, value);
  }

  /** The event that is emitted when the slot is assigned; it is created on first use. */
  private static UrbiObject changed(Frame frame, UrbiObject holder, Symbol slot) {
    SlotData data = holder.ensureSlotData(slot);
    UrbiObject event = data.changed();
    if (event == null) {
      event = frame.interpreter.prototypes.event.cloned();
      data.setChanged(event);
      data.setProperty("changed", event);
      holder.slotDataChanged(slot);
    }
    return event;
  }

  private static UrbiObject holder(Frame frame, UrbiObject target, Symbol slot) {
    UrbiObject holder = target.locate(slot);
    if (holder == null) {
      throw frame.interpreter.errors().lookup(target, slot.name());
    }
    return holder;
  }

  /** Sets a property, with the effect of the system's own properties. */
  public static void set(
      Frame frame, UrbiObject target, Symbol slot, String property, UrbiObject given) {
    if (target instanceof SlotProxy proxy && target.shape().indexOf(slot) < 0) {
      proxy.setProperty(frame, slot, property, given);
      return;
    }
    UrbiObject value = TakenCode.by(frame, given);
    UrbiObject holder = holder(frame, target, slot);
    PermissionCheck.checkChange(frame, "setProperty", holder);
    SlotBlending blending = property.equals("blend") ? blending(frame, value) : null;
    SlotData data = holder.ensureSlotData(slot);
    data.setProperty(property, value);
    switch (property) {
      case "blend" -> data.setBlending(blending);
      case "constant" -> data.setConstant(Truth.of(frame, value));
      case "changed" -> data.setChanged(value);
      case "get" -> data.setGetter(value);
      case "set" -> data.setSetter(value);
      case "updateHook" -> data.setUpdateHook(value);
      case "rangemin" -> data.setLeast(value);
      case "rangemax" -> data.setMost(value);
      default -> {}
    }
    holder.slotDataChanged(slot);
  }

  /** The state that the slot needs for that blend mode; null for none. */
  private static @Nullable Blending blending(Frame frame, UrbiObject value) {
    BlendMode mode = BlendMode.of(value);
    if (mode == null) {
      throw frame
          .interpreter
          .errors()
          .primitive(
              "setProperty", Problem.BLEND_MODE, frame.interpreter.asPrintable(frame, value));
    }
    return mode == BlendMode.NORMAL ? null : new Blending(mode);
  }

  /** Removes a property; null when there was none. */
  public static @Nullable UrbiObject remove(
      Frame frame, UrbiObject target, Symbol slot, String property) {
    UrbiObject holder = holder(frame, target, slot);
    PermissionCheck.checkChange(frame, "removeProperty", holder);
    SlotData data = holder.slotData(slot);
    if (data == null) {
      return null;
    }
    switch (property) {
      case "blend" -> data.setBlending(null);
      case "constant" -> data.setConstant(false);
      case "changed" -> data.setChanged(null);
      case "get" -> data.setGetter(null);
      case "set" -> data.setSetter(null);
      case "updateHook" -> data.setUpdateHook(null);
      case "rangemin" -> data.setLeast(null);
      case "rangemax" -> data.setMost(null);
      default -> {}
    }
    UrbiObject removed = data.removeProperty(property);
    holder.slotDataChanged(slot);
    return taken(frame, removed);
  }

  // ------------------------------------------------------------------ nodes

  /** {@code target.slot->property}. */
  public static final class Read extends Node {
    private final Node target;
    private final Symbol slot;
    private final String property;

    public Read(Span span, Node target, Symbol slot, String property) {
      super(span);
      this.target = target;
      this.slot = slot;
      this.property = property;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject object = target.execute(frame);
      try {
        return get(frame, object, slot, property);
      } catch (UrbiException e) {
        throw frame.located(e, span());
      }
    }
  }

  static UrbiObject get(Frame frame, UrbiObject object, Symbol slot, String property) {
    UrbiObject value = find(frame, object, slot, property);
    if (value == null) {
      throw frame.interpreter.errors().property(object, slot.name(), property);
    }
    return value;
  }

  /** {@code target.slot->property = value}. */
  public static final class Write extends Node {
    private final Node target;
    private final Symbol slot;
    private final String property;
    private final Node value;

    /**
     * @param span where the property is written, without the value
     */
    public Write(Span span, Node target, Symbol slot, String property, Node value) {
      super(span);
      this.target = target;
      this.slot = slot;
      this.property = property;
      this.value = value;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject object = target.execute(frame);
      UrbiObject assigned = ArgumentEvaluation.notVoid(frame, value, span());
      try {
        set(frame, object, slot, property, assigned);
      } catch (UrbiException e) {
        throw frame.located(e, span());
      }
      return assigned;
    }
  }

  /** {@code get x() {…}} and {@code set x(var v) {…}}: a slot computed by functions. */
  public static final class Accessor extends Node {
    private final Node target;
    private final Symbol slot;
    private final boolean setter;
    private final Node function;

    public Accessor(Span span, Node target, Symbol slot, boolean setter, Node function) {
      super(span);
      this.target = target;
      this.slot = slot;
      this.setter = setter;
      this.function = function;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject object = target.execute(frame);
      UrbiObject value = function.execute(frame);
      if (!object.hasLocalSlot(slot)) {
        PermissionCheck.checkChange(frame, "setSlot", object);
        object.addSlot(slot, frame.interpreter.values().voidObject);
      }
      set(frame, object, slot, setter ? "set" : "get", value);
      return value;
    }
  }
}

package org.urbi.kernel.library;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.Map;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/** A variable with callbacks, which stands behind a slot (manual, "UVar"). */
final class UrbiUVar extends UrbiObject {
  private final Map<Long, UrbiObject> onChange = new LinkedHashMap<>();
  private final Map<Long, UrbiObject> onAccess = new LinkedHashMap<>();
  private UrbiObject value;
  private boolean busy;
  private boolean owned;
  private long lastId;

  UrbiUVar(Shape shape) {
    super(shape);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiUVar(cloneShape());
  }

  /** Puts this variable behind a slot of an object. */
  void bind(Frame frame, UrbiObject owner, Symbol name) {
    if (value == null) {
      UrbiObject known = owner.localSlot(name);
      value = known == null ? frame.interpreter().values().voidObject : known;
    }
    if (owner.localSlot(name) == null) {
      owner.addSlot(name, this);
    } else {
      owner.setSlotAt(owner.shape().indexOf(name), this);
    }
    SlotData data = owner.ensureSlotData(name);
    Shape code = frame.interpreter().prototypes().code.cloneShape();
    data.getter = new Access(code, false);
    data.setter = new Access(code, true);
    owner.slotDataChanged(name);
  }

  boolean isOwned() {
    return owned;
  }

  /** Calls a function at each change; returns the number by which to remove it. */
  long notifyChange(UrbiObject function) {
    onChange.put(++lastId, function);
    return lastId;
  }

  /** As {@link #notifyChange}, for a variable whose commands and sensed values differ. */
  long notifyChangeOwned(UrbiObject function) {
    owned = true;
    return notifyChange(function);
  }

  /** Calls a function at each access; returns the number by which to remove it. */
  long notifyAccess(UrbiObject function) {
    onAccess.put(++lastId, function);
    return lastId;
  }

  boolean removeChange(long id) {
    return onChange.remove(id) != null;
  }

  boolean removeAccess(long id) {
    return onAccess.remove(id) != null;
  }

  private UrbiObject read(Frame frame) {
    call(frame, onAccess);
    return value;
  }

  private UrbiObject write(Frame frame, UrbiObject other) {
    value = other;
    call(frame, onChange);
    return other;
  }

  /** A callback that reads or writes the variable is not called again for that. */
  private void call(Frame frame, Map<Long, UrbiObject> callbacks) {
    if (callbacks.isEmpty() || busy) {
      return;
    }
    busy = true;
    try {
      for (UrbiObject callback : new ArrayList<>(callbacks.values())) {
        frame.interpreter().call(frame, callback, this);
      }
    } finally {
      busy = false;
    }
  }

  /** Reads or writes the variable when its slot is read or written. */
  private final class Access extends Code {
    private final boolean writes;

    Access(Shape shape, boolean writes) {
      super(shape);
      this.writes = writes;
    }

    @Override
    public boolean isLazy() {
      return false;
    }

    @Override
    public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
      return writes ? write(caller, arguments[0]) : read(caller);
    }
  }
}

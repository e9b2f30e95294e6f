package org.urbi.kernel.node;

import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/** An object that stands for others: operations on its slots apply to theirs. */
public interface SlotProxy {
  /** {@code target.slot = value}; returns the value of the assignment. */
  UrbiObject updateSlot(Frame frame, Symbol slot, UrbiObject value);

  /** {@code target.slot->property}; null when there is none. */
  UrbiObject property(Frame frame, Symbol slot, String property);

  /** {@code target.slot->property = value}. */
  void setProperty(Frame frame, Symbol slot, String property, UrbiObject value);
}

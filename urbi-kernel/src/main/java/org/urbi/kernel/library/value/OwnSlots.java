package org.urbi.kernel.library.value;

import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/** Slots in which objects of the library keep what programs may read, and often write. */
public final class OwnSlots {
  private OwnSlots() {}

  /** The value of a slot, its own or inherited; a getter is called. */
  public static UrbiObject get(Frame frame, UrbiObject self, String name) {
    return frame.interpreter().get(frame, self, self.world().symbol(name));
  }

  /** Assigns a slot, or creates it; its watchers are notified. */
  public static void set(Frame frame, UrbiObject self, String name, UrbiObject value) {
    Symbol symbol = self.world().symbol(name);
    if (self.locate(symbol) == null) {
      self.addSlot(symbol, value);
    } else {
      SlotUpdate.assign(frame, self, symbol, value);
    }
  }

  /** Gives a fresh object a slot; one that it has already gets that value, and nothing more. */
  public static void put(UrbiObject self, String name, UrbiObject value) {
    Symbol symbol = self.world().symbol(name);
    self.removeSlot(symbol);
    self.addSlot(symbol, value);
  }
}

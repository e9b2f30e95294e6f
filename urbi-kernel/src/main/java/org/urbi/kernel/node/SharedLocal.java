package org.urbi.kernel.node;

import org.urbi.kernel.object.Dependencies;
import org.urbi.kernel.object.UrbiObject;

/**
 * Stands among the locals of frames for a variable that was plain until another job began to
 * execute an expression with it. Its copies are the same variable: whoever assigns it, all see it.
 * No code ever gets hold of it.
 */
final class SharedLocal extends UrbiObject {
  private final Cell cell;

  SharedLocal(UrbiObject value) {
    super(value.world().values().object.cloneShape());
    cell = new Cell(value);
  }

  UrbiObject get() {
    Dependencies.Tracker tracker = world().tracker;
    return tracker == null ? cell.get() : cell.getTracked(tracker);
  }

  /** Assigns the variable with that index, shared or not. */
  static void store(UrbiObject[] locals, int index, UrbiObject value) {
    if (locals[index] instanceof SharedLocal shared) {
      shared.set(value);
    } else {
      locals[index] = value;
    }
  }

  private void set(UrbiObject value) {
    if (cell.get() != value) {
      cell.set(value);
    }
  }
}

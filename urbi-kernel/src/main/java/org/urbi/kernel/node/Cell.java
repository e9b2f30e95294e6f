package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.Dependencies;
import org.urbi.kernel.object.UrbiObject;

/** A local variable that closures or other jobs can reach. */
final class Cell {
  private UrbiObject value;
  private @Nullable Dependencies dependents;

  Cell(UrbiObject value) {
    this.value = value;
  }

  UrbiObject get() {
    return value;
  }

  /** Reads the value for the condition which is being evaluated. */
  UrbiObject getTracked(Dependencies.Tracker tracker) {
    if (dependents == null) {
      dependents = new Dependencies("(a local variable)");
    }
    tracker.read(dependents);
    return value;
  }

  void set(UrbiObject other) {
    value = other;
    if (dependents != null) {
      dependents.changed();
    }
  }
}

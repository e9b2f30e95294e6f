package org.urbi.kernel.node;

import org.urbi.kernel.object.UrbiObject;

/** The number of variables of an activation; complete once all of its code has been compiled. */
public final class FrameLayout {
  private static final UrbiObject[] NO_LOCALS = {};
  static final Cell[] NO_CELLS = {};

  private int locals;
  private int cells;

  /** Adds a variable that only one job can reach, and returns its index. */
  public int addLocal() {
    return locals++;
  }

  /** Adds a variable that closures or other jobs can reach, and returns the index of its cell. */
  public int addCell() {
    return cells++;
  }

  public int locals() {
    return locals;
  }

  boolean hasCells() {
    return cells > 0;
  }

  UrbiObject[] newLocals() {
    return locals == 0 ? NO_LOCALS : new UrbiObject[locals];
  }

  Cell[] newCells() {
    return cells == 0 ? NO_CELLS : new Cell[cells];
  }
}

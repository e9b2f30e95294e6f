package org.urbi.kernel.node;

import org.urbi.kernel.object.UrbiObject;

/** How many variables an activation needs; known when its code has been compiled whole. */
public final class FrameLayout {
  private static final UrbiObject[] NO_LOCALS = {};
  private static final Cell[] NO_CELLS = {};

  private int locals;
  private int cells;

  /** A new place for a variable that only one job can reach. */
  public int addLocal() {
    return locals++;
  }

  /** A new place for a variable that closures or other jobs reach. */
  public int addCell() {
    return cells++;
  }

  public int locals() {
    return locals;
  }

  UrbiObject[] newLocals() {
    return locals == 0 ? NO_LOCALS : new UrbiObject[locals];
  }

  Cell[] newCells() {
    return cells == 0 ? NO_CELLS : new Cell[cells];
  }
}

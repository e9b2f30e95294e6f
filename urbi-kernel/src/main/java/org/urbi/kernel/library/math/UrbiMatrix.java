package org.urbi.kernel.library.math;

import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/**
 * A matrix of numbers, kept row by row. Its array is never changed, only replaced, so that clones
 * share it.
 */
final class UrbiMatrix extends UrbiObject {
  private int rows;
  private int columns;
  private double[] elements;

  UrbiMatrix(Shape shape, int rows, int columns, double[] elements) {
    super(shape);
    this.rows = rows;
    this.columns = columns;
    this.elements = elements;
  }

  int rows() {
    return rows;
  }

  int columns() {
    return columns;
  }

  double[] elements() {
    noteContentRead();
    return elements;
  }

  void set(int newRows, int newColumns, double[] values) {
    rows = newRows;
    columns = newColumns;
    elements = values;
    noteContentChange();
  }

  /** Another matrix. */
  UrbiMatrix sibling(int itsRows, int itsColumns, double[] values) {
    return new UrbiMatrix(world().prototype("Matrix").cloneShape(), itsRows, itsColumns, values);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiMatrix(cloneShape(), rows, columns, elements);
  }
}

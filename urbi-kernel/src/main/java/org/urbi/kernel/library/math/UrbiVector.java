package org.urbi.kernel.library.math;

import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A vector of numbers. Its array is never changed, only replaced, so that clones share it. */
final class UrbiVector extends UrbiObject {
  private double[] elements;

  UrbiVector(Shape shape, double[] elements) {
    super(shape);
    this.elements = elements;
  }

  double[] elements() {
    noteContentRead();
    return elements;
  }

  void setElements(double[] values) {
    elements = values;
    noteContentChange();
  }

  /** Another vector of the same type. */
  UrbiVector sibling(double[] values) {
    return new UrbiVector(world().prototype("Vector").cloneShape(), values);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiVector(cloneShape(), elements);
  }
}

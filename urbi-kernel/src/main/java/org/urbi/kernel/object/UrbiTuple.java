package org.urbi.kernel.object;

import java.util.List;

/** A tuple (manual, "Tuple"): a fixed number of elements. */
public final class UrbiTuple extends UrbiObject {
  private UrbiObject[] elements;

  public UrbiTuple(Shape shape, List<? extends UrbiObject> elements) {
    super(shape);
    this.elements = elements.toArray(UrbiObject[]::new);
  }

  public int size() {
    return elements.length;
  }

  public UrbiObject get(int index) {
    noteContentRead();
    return elements[index];
  }

  public void set(int index, UrbiObject value) {
    elements[index] = value;
    noteContentChange();
  }

  /** Replaces all elements; for constructors. */
  public void setElements(List<? extends UrbiObject> others) {
    elements = others.toArray(UrbiObject[]::new);
    noteContentChange();
  }

  public List<UrbiObject> elements() {
    noteContentRead();
    return List.of(elements);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiTuple(cloneShape(), List.of(elements));
  }
}

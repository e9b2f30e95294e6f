package org.urbi.kernel.object;

/**
 * A number (manual, "Float"). Its value never changes, from when somebody has seen the object on:
 * before that a slot may keep its number in it.
 */
public final class UrbiFloat extends UrbiObject {
  private double value;

  public UrbiFloat(Shape shape, double value) {
    super(shape);
    this.value = value;
  }

  public double value() {
    return value;
  }

  /** Whether it has no slots, and inherits from nothing but the library. */
  boolean isPlain() {
    return shape.ofNumbers;
  }

  /** Another number stands in the slot that has this object. */
  void become(double other) {
    value = other;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiFloat(cloneShape(), value);
  }
}

package org.urbi.kernel.object;

/** A number (manual, "Float"). Its value never changes. */
public final class UrbiFloat extends UrbiObject {
  private final double value;

  public UrbiFloat(Shape shape, double value) {
    super(shape);
    this.value = value;
  }

  public double value() {
    return value;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiFloat(cloneShape(), value);
  }
}

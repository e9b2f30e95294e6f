package org.urbi.kernel.object;

/**
 * A string (manual, "String"): a sequence of bytes, each of which is a {@code char} from 0 to 255.
 * Assigning to a range of it changes it in place.
 */
public final class UrbiString extends UrbiObject {
  private String value;

  public UrbiString(Shape shape, String value) {
    super(shape);
    this.value = value;
  }

  public String value() {
    noteContentRead();
    return value;
  }

  public void setValue(String other) {
    value = other;
    noteContentChange();
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiString(cloneShape(), value);
  }
}

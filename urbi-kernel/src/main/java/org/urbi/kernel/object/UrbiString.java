package org.urbi.kernel.object;

/**
 * A string (manual, "String"): a sequence of bytes, each of which is a {@code char} from 0 to 255.
 * Assigning to a range of it changes it in place.
 *
 * <p>Long strings that grow by appending share one buffer, each of them a beginning of it, so that
 * a text of n pieces takes n steps and not n².
 */
public final class UrbiString extends UrbiObject {
  /** Shorter ones are copied: that is cheap, and needs one object less. */
  private static final int SHARED_LENGTH = 1024;

  /** Null as long as nobody has asked for it, and only the buffer has it. */
  private String value;

  /** The buffer that begins with this string, or null. */
  private StringBuilder buffer;

  private int length;

  public UrbiString(Shape shape, String value) {
    super(shape);
    this.value = value;
    this.length = value.length();
  }

  private UrbiString(Shape shape, StringBuilder buffer) {
    super(shape);
    this.buffer = buffer;
    this.length = buffer.length();
  }

  public String value() {
    noteContentRead();
    if (value == null) {
      value = buffer.substring(0, length);
    }
    return value;
  }

  public void setValue(String other) {
    value = other;
    length = other.length();
    buffer = null;
    noteContentChange();
  }

  /** A new string of that shape: this one, and then the other. */
  UrbiString followedBy(Shape shape, String other) {
    if (length + other.length() < SHARED_LENGTH) {
      return new UrbiString(shape, value().concat(other));
    }
    noteContentRead();
    StringBuilder shared = buffer;
    if (shared == null || shared.length() != length) {
      shared = new StringBuilder(value());
    }
    shared.append(other);
    buffer = shared;
    return new UrbiString(shape, shared);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiString(cloneShape(), value());
  }
}

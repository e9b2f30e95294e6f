package org.urbi.kernel.object;

import static java.util.Objects.requireNonNull;

import org.jspecify.annotations.Nullable;

/**
 * A string (manual, "String"): a sequence of bytes, each of which is a {@code char} from 0 to 255.
 * Assigning to a range of it changes it in place.
 *
 * <p>Long strings that grow by appending share one buffer, of which each is a prefix, so that
 * building a text of n pieces takes linear time.
 */
public final class UrbiString extends UrbiObject {
  /** Shorter strings are copied, which is cheap and needs one object less. */
  private static final int SHARED_LENGTH = 1024;

  private static final int SHORT_LENGTH = 256;

  /** The text; null while it is only in the buffer. */
  private @Nullable String value;

  /** The buffer that begins with this string, or null. */
  private @Nullable StringBuilder buffer;

  /** Whether no other string shares the buffer, so that it can be modified in place. */
  private boolean own;

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
    String known = value;
    if (known == null) {
      known = buffer().substring(0, length);
      value = known;
    }
    return known;
  }

  private StringBuilder buffer() {
    return requireNonNull(buffer, "what is not in the value is in the buffer");
  }

  public void setValue(String other) {
    value = other;
    length = other.length();
    buffer = null;
    own = false;
    noteContentChange();
  }

  /** Whether to compare it, or to find it in a dictionary, takes some nanoseconds at most. */
  public boolean isShort() {
    return length <= SHORT_LENGTH;
  }

  /** The number of characters. */
  public int length() {
    noteContentRead();
    return length;
  }

  /** The characters from an index to another one, which is excluded. */
  public String part(int begin, int end) {
    noteContentRead();
    return value == null ? buffer().substring(begin, end) : value.substring(begin, end);
  }

  /** Replaces the characters from an index to another one, which is excluded, in place. */
  public void replace(int begin, int end, String other) {
    if (!own) {
      buffer = new StringBuilder(value());
      own = true;
    }
    StringBuilder changed = buffer();
    if (end - begin == 1 && other.length() == 1) {
      changed.setCharAt(begin, other.charAt(0));
    } else {
      changed.replace(begin, end, other);
    }
    value = null;
    length = changed.length();
    noteContentChange();
  }

  /** A new string of that shape: this one followed by the other. */
  UrbiString followedBy(Shape shape, String other) {
    if (length + other.length() < SHARED_LENGTH) {
      return new UrbiString(shape, value().concat(other));
    }
    noteContentRead();
    StringBuilder shared = buffer;
    if (shared == null || own || shared.length() != length) {
      shared = new StringBuilder(length + other.length()).append(value());
    }
    shared.append(other);
    buffer = shared;
    own = false;
    return new UrbiString(shape, shared);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiString(cloneShape(), value());
  }
}

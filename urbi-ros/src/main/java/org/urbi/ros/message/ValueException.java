package org.urbi.ros.message;

/** A value that is not of the type of a message. The message names the field by its path. */
public class ValueException extends IllegalArgumentException {
  private final String path;
  private final String reason;

  /** What is wrong with a value; the callers that know its field add it with {@link #within}. */
  public ValueException(String reason) {
    this("", reason);
  }

  private ValueException(String path, String reason) {
    super(path.isEmpty() ? reason : path + ": " + reason);
    this.path = path;
    this.reason = reason;
  }

  /** What is wrong within the field of that name, or the element {@code [3]}. */
  public ValueException within(String step) {
    String separator = path.isEmpty() || path.startsWith("[") ? "" : ".";
    return new ValueException(step + separator + path, reason);
  }

  /** No stack trace: people do not want to know where in this module it was thrown. */
  @Override
  public synchronized Throwable fillInStackTrace() {
    return this;
  }
}

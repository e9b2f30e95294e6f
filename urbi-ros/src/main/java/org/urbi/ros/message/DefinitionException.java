package org.urbi.ros.message;

/**
 * A type that cannot be had: no file of it, or one that is not right. The message is for people.
 */
public class DefinitionException extends IllegalArgumentException {
  public DefinitionException(String message) {
    super(message);
  }

  /** No stack trace: people do not want to know where in this module it was thrown. */
  @Override
  public synchronized Throwable fillInStackTrace() {
    return this;
  }
}

package org.urbi.ros.message;

/** A value that is not of the type of a message. The message names the field by its path. */
public class ValueException extends RuntimeException {
  public ValueException(String message) {
    super(message);
  }
}

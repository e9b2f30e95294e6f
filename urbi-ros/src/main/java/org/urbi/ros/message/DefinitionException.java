package org.urbi.ros.message;

/**
 * A type that cannot be had: no file of it, or one that is not right. The message is for people.
 */
public class DefinitionException extends RuntimeException {
  public DefinitionException(String message) {
    super(message);
  }
}

package org.urbi.kernel.uobject;

import org.urbi.kernel.error.UrbiException;

/** Carries an urbiscript exception through Java code. */
final class PropagatedUrbiException extends RuntimeException {
  private final transient UrbiException original;

  PropagatedUrbiException(String message, UrbiException original) {
    super(message, null, false, false);
    this.original = original;
  }

  UrbiException original() {
    return original;
  }
}

package org.urbi.kernel.uobject;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;

/** A value of urbiscript cannot be what Java code wants; it carries no Java stack trace. */
final class ConversionFailure extends RuntimeException {
  private final transient UrbiObject given;
  private final @Nullable String expected;

  /**
   * @param expected the type in urbiscript
   * @param message what else there is to say, or null
   */
  ConversionFailure(UrbiObject given, @Nullable String expected, @Nullable String message) {
    super(message, null, false, false);
    this.given = given;
    this.expected = expected;
  }

  UrbiObject given() {
    return given;
  }

  @Nullable String expected() {
    return expected;
  }
}

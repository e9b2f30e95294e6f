package org.urbi.kernel.uobject;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;

/**
 * An urbiscript value cannot be converted to the type that Java code expects. It has no Java stack
 * trace.
 */
final class ConversionFailure extends RuntimeException {
  private final transient UrbiObject given;
  private final @Nullable String expected;

  /**
   * @param expected the type in urbiscript
   * @param message further explanation, or null
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

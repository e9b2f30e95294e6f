package org.urbi.kernel.variable;

import org.urbi.kernel.object.UrbiObject;

/**
 * One value of a variable. What Java code has written stays as it is until urbiscript wants to see
 * it: Java code that reads it gets the very same.
 */
public final class Datum {
  /** A value that is not of urbiscript. */
  @FunctionalInterface
  public interface Foreign {
    /** A copy of it for urbiscript. */
    UrbiObject copy();
  }

  private final Foreign foreign;
  private UrbiObject value;

  public Datum(UrbiObject value) {
    this.value = value;
    this.foreign = null;
  }

  public Datum(Foreign foreign) {
    this.foreign = foreign;
  }

  /** The value for urbiscript. */
  public UrbiObject value() {
    if (value == null) {
      value = foreign.copy();
    }
    return value;
  }

  /** What Java code has written; null if urbiscript has written the value. */
  public Foreign foreign() {
    return foreign;
  }
}

package org.urbi.kernel.variable;

import static java.util.Objects.requireNonNull;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;

/**
 * One value of a variable. A value written by Java code is kept as a Java object until urbiscript
 * reads it, so that Java code that reads it gets the very same object.
 */
public final class Datum {
  /** A value that is no urbiscript object. */
  @FunctionalInterface
  public interface Foreign {
    /** A copy of it for urbiscript. */
    UrbiObject copy();
  }

  private final @Nullable Foreign foreign;
  private @Nullable UrbiObject value;

  public Datum(UrbiObject value) {
    this.value = value;
    this.foreign = null;
  }

  public Datum(Foreign foreign) {
    this.foreign = foreign;
  }

  /** The value for urbiscript. */
  public UrbiObject value() {
    UrbiObject known = value;
    if (known == null) {
      known = requireNonNull(foreign, "a value is of urbiscript, or foreign").copy();
      value = known;
    }
    return known;
  }

  /** The Java value; null if urbiscript has written the value. */
  public @Nullable Foreign foreign() {
    return foreign;
  }
}

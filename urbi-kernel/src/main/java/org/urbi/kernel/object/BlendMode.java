package org.urbi.kernel.object;

import java.util.Locale;
import org.jspecify.annotations.Nullable;

/** How simultaneous assignments to one slot are combined: its property {@code blend}. */
public enum BlendMode {
  // The order is that of the numbers that UObjects use.
  /** The average of the assigned values. */
  MIX,
  /** The sum of the assigned values. */
  ADD,
  /** Assignments during a motion are ignored. */
  DISCARD,
  /** Assignments during a motion wait for its end. */
  QUEUE,
  /** An assignment ends the motions in progress. */
  CANCEL,
  /** Each assignment is executed; the last one counts. */
  NORMAL;

  /** The name in urbiscript. */
  public String text() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The mode for a value of the property, a name or a number; null if there is none. */
  public static @Nullable BlendMode of(UrbiObject value) {
    for (BlendMode mode : values()) {
      if (value instanceof UrbiString name && name.value().equals(mode.text())
          || value instanceof UrbiFloat number && number.value() == mode.ordinal()) {
        return mode;
      }
    }
    return null;
  }
}

package org.urbi.kernel.object;

import java.util.Locale;
import org.jspecify.annotations.Nullable;

/** What becomes of several assignments of one slot at a time: its property {@code blend}. */
public enum BlendMode {
  // In the order of the numbers that UObjects know them by.
  /** The average of what is assigned. */
  MIX,
  /** The sum of what is assigned. */
  ADD,
  /** Whoever comes during a motion is ignored. */
  DISCARD,
  /** Whoever comes during a motion waits for its end. */
  QUEUE,
  /** Whoever comes ends the motions that are going on. */
  CANCEL,
  /** Each assigns, the last one counts. */
  NORMAL;

  /** The name in urbiscript. */
  public String text() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The mode that a value of the property stands for, a name or a number; null when none is. */
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

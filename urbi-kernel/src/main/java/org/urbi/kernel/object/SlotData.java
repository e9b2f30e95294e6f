package org.urbi.kernel.object;

import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * The properties of a slot (manual, "Properties"). Plain slots have none of this, and do not pay
 * for it.
 */
public final class SlotData {
  /**
   * Properties by name, {@code constant} included, in the order in which they are listed. The slots
   * behind which the same UVar stands have them together.
   */
  public TreeMap<String, UrbiObject> properties = new TreeMap<>();

  /** May the slot be assigned? */
  public boolean constant;

  /** The property {@code changed}, emitted at each assignment; created on first use. */
  public @Nullable UrbiObject changed;

  /** A function called for the value instead of the slot, or null. */
  public @Nullable UrbiObject getter;

  /** A function called with the value that is assigned, or null. */
  public @Nullable UrbiObject setter;

  /** A function that computes the value to assign from the given one, or null. */
  public @Nullable UrbiObject updateHook;

  /** The limits to which assigned numbers are clamped; null for none. */
  public @Nullable UrbiObject least;

  /** See {@link #least}. */
  public @Nullable UrbiObject most;

  /** Conditions that read this slot; null while there are none. */
  public @Nullable Dependencies dependents;

  /** Whether the slot is no longer there. */
  public boolean removed;

  /**
   * The state of simultaneous assignments ({@code blend}), which the interpreter keeps here; or
   * null.
   */
  public @Nullable Object blending;

  byte flags() {
    byte flags = 0;
    if (constant
        || changed != null
        || setter != null
        || updateHook != null
        || least != null
        || most != null
        || dependents != null
        || getter != null
        || blending != null) {
      flags |= Shape.WRITE_SPECIAL;
    }
    if (getter != null) {
      flags |= Shape.READ_SPECIAL;
    }
    return flags;
  }
}

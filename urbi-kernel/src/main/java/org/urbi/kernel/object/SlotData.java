package org.urbi.kernel.object;

import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * What a slot has besides its value (manual, "Properties"): plain slots have none of this and do
 * not pay for it.
 */
public final class SlotData {
  /** Properties by name, {@code constant} included, in the order in which they are listed. */
  public final TreeMap<String, UrbiObject> properties = new TreeMap<>();

  /** May the slot be assigned? */
  public boolean constant;

  /** Emitted at each assignment: the {@code changed} property, made when first asked for. */
  public @Nullable UrbiObject changed;

  /** A function called for the value instead of the slot, or null. */
  public @Nullable UrbiObject getter;

  /** A function called with the value that is assigned, or null. */
  public @Nullable UrbiObject setter;

  /** A function that is asked for the value to assign instead of the one given, or null. */
  public @Nullable UrbiObject updateHook;

  /** The least and the greatest number that an assignment leaves; null when there is no limit. */
  public @Nullable UrbiObject least;

  /** See {@link #least}. */
  public @Nullable UrbiObject most;

  /** Conditions that read this slot; null while there are none. */
  public @Nullable Dependencies dependents;

  /** Whether the slot is no longer there. */
  public boolean removed;

  /** What those who execute code know of assignments at the same time, {@code blend}; or null. */
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

package org.urbi.kernel.object;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * The properties of a slot (manual, "Properties"). Plain slots have none of this, and do not pay
 * for it. Whoever changes something of it tells the object of the slot ({@link
 * UrbiObject#slotDataChanged}).
 */
public final class SlotData {
  private TreeMap<String, UrbiObject> properties = new TreeMap<>();
  private boolean constant;
  private boolean removed;
  private @Nullable UrbiObject changed;
  private @Nullable UrbiObject getter;
  private @Nullable UrbiObject setter;
  private @Nullable UrbiObject updateHook;
  private @Nullable UrbiObject least;
  private @Nullable UrbiObject most;
  private @Nullable Dependencies dependents;
  private @Nullable SlotBlending blending;

  /** A property; null if there is none of that name. */
  public @Nullable UrbiObject property(String name) {
    return properties.get(name);
  }

  /** The properties by name, {@code constant} included, in the order in which they are listed. */
  public Map<String, UrbiObject> properties() {
    return Collections.unmodifiableMap(properties);
  }

  public void setProperty(String name, UrbiObject value) {
    properties.put(name, value);
  }

  /** Removes a property, and returns its value; null if there is none of that name. */
  public @Nullable UrbiObject removeProperty(String name) {
    return properties.remove(name);
  }

  /** From now on the slot has its properties together with others behind which the same UVar is. */
  public void shareProperties(TreeMap<String, UrbiObject> all) {
    all.putAll(properties);
    properties = all;
  }

  /** Whether the slot may not be assigned. */
  public boolean isConstant() {
    return constant;
  }

  public void setConstant(boolean on) {
    constant = on;
  }

  /** Whether the slot is no longer there. */
  public boolean isRemoved() {
    return removed;
  }

  /** Notes that the slot is no longer there; conditions that read it are evaluated anew. */
  void remove() {
    removed = true;
    if (dependents != null) {
      dependents.changed();
    }
  }

  /** The property {@code changed}, emitted at each assignment; null until somebody asks for it. */
  public @Nullable UrbiObject changed() {
    return changed;
  }

  public void setChanged(@Nullable UrbiObject other) {
    changed = other;
  }

  /** A function called for the value instead of the slot, or null. */
  public @Nullable UrbiObject getter() {
    return getter;
  }

  public void setGetter(@Nullable UrbiObject other) {
    getter = other;
  }

  /** A function called with the value that is assigned, or null. */
  public @Nullable UrbiObject setter() {
    return setter;
  }

  public void setSetter(@Nullable UrbiObject other) {
    setter = other;
  }

  /** A function that computes the value to assign from the given one, or null. */
  public @Nullable UrbiObject updateHook() {
    return updateHook;
  }

  public void setUpdateHook(@Nullable UrbiObject other) {
    updateHook = other;
  }

  /** The least number that may be assigned: less is limited to it; null for none. */
  public @Nullable UrbiObject least() {
    return least;
  }

  public void setLeast(@Nullable UrbiObject other) {
    least = other;
  }

  /** The greatest number that may be assigned: more is limited to it; null for none. */
  public @Nullable UrbiObject most() {
    return most;
  }

  public void setMost(@Nullable UrbiObject other) {
    most = other;
  }

  /** The conditions that read this slot; null while there are none. */
  public @Nullable Dependencies dependents() {
    return dependents;
  }

  public void setDependents(@Nullable Dependencies other) {
    dependents = other;
  }

  /** The state of simultaneous assignments, or null. */
  public @Nullable SlotBlending blending() {
    return blending;
  }

  public void setBlending(@Nullable SlotBlending other) {
    blending = other;
  }

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

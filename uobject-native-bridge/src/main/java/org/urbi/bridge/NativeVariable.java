package org.urbi.bridge;

import urbi.USlot;
import urbi.UValue;

/** A variable as C++ code knows it. */
final class NativeVariable {
  private final USlot slot;
  private volatile boolean bypass;
  private volatile HeaderCache header = HeaderCache.NONE;

  NativeVariable(USlot slot) {
    this.slot = slot;
  }

  USlot slot() {
    return slot;
  }

  /** Switches the 0-copy mode; false if the context has none. */
  boolean setBypass(boolean on) {
    boolean can = slot.setBypass(on);
    bypass = on && can;
    return can;
  }

  /** Writes the value that C++ code wants to write. */
  void set(ValueReader in) {
    SharedBinary shared = bypass ? in.shared(header) : null;
    if (shared == null) {
      slot.set(in.value());
      return;
    }
    if (header != shared.header()) {
      header = shared.header();
    }
    try (shared) {
      slot.set(new UValue(shared.binary()));
    }
  }
}

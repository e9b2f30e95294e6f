package org.urbi.bridge;

import org.jspecify.annotations.Nullable;
import urbi.UObjectHub;

/** The Java side of a hub that is written in C++. */
final class NativeHub extends UObjectHub implements AutoCloseable {
  private @Nullable NativeInstance resident;

  private NativeHub(String name) {
    super(name);
  }

  /** Makes one with its C++ side. */
  static NativeHub create(NativeModule module, String name) {
    NativeHub made = new NativeHub(name);
    made.resident = NativeInstance.ofHub(module.in(made.getUContext()), made);
    return made;
  }

  /** Its C++ side; null while that is being made, and when it is gone. */
  @Nullable NativeInstance resident() {
    return resident;
  }

  /** The hub is no longer used: the C++ hub is deleted. */
  @Override
  public void close() {
    NativeInstance ended = resident;
    resident = null;
    if (ended != null) {
      ended.end();
    }
  }
}

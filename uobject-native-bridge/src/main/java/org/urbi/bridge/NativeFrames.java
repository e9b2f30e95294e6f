package org.urbi.bridge;

import java.util.function.Supplier;

/** The calls of native code that a thread executes: a job that has some cannot wait. */
final class NativeFrames {
  private static final ThreadLocal<NativeFrames> OF_THREAD =
      ThreadLocal.withInitial(NativeFrames::new);

  private int count;
  private boolean held;

  private NativeFrames() {}

  /** This thread calls native code; to be ended by {@link #leave}. */
  static NativeFrames enter() {
    NativeFrames own = OF_THREAD.get();
    own.count++;
    return own;
  }

  void leave() {
    count--;
  }

  /** Whether this is the thread of a job, and executes native code that waits for what it does. */
  static boolean holdJob() {
    return Thread.currentThread().isVirtual() && OF_THREAD.get().count > 0;
  }

  /** Executes code for a job that cannot wait. */
  static <T> T held(Supplier<T> code) {
    NativeFrames own = OF_THREAD.get();
    boolean before = own.held;
    own.held = true;
    try {
      return code.get();
    } finally {
      own.held = before;
    }
  }

  /** Whether this thread executes code for a job that cannot wait. */
  static boolean isHeld() {
    return OF_THREAD.get().held;
  }
}

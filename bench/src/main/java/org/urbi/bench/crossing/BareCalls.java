package org.urbi.bench.crossing;

import com.sun.jna.Callback;
import com.sun.jna.Native;
import com.sun.jna.NativeLibrary;
import java.nio.file.Path;

/** JNA's own direct calls and callbacks: what everything else is compared with. */
final class BareCalls {
  private interface Step extends Callback {
    int next(int x);
  }

  private static final Step STEP = x -> x + 1;

  private BareCalls() {}

  private static native int bare_call(int x);

  private static native int bare_callbacks(Step step, int count);

  static void map(Path library) {
    Native.register(BareCalls.class, NativeLibrary.getInstance(library.toString()));
  }

  static void calls(int count) {
    int x = 0;
    for (int i = 0; i < count; i++) {
      x = bare_call(x);
    }
    check(x, count);
  }

  static void callbacks(int count) {
    check(bare_callbacks(STEP, count), count);
  }

  private static void check(int result, int expected) {
    if (result != expected) {
      throw new IllegalStateException(result + " instead of " + expected);
    }
  }
}

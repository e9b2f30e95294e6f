package org.urbi.kernel.job;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Method;
import org.jspecify.annotations.Nullable;

/**
 * Keeps a job on the kernel thread while it executes code that is not ours. Whatever that code
 * waits for, the kernel waits with it (manual, "Asynchronous binding": such calls block
 * everything), where otherwise the virtual thread of the job would be put aside and the others
 * would go on.
 */
public final class KernelThreadPin {
  private static final @Nullable MethodHandle PIN = find("pin");
  private static final @Nullable MethodHandle UNPIN = find("unpin");

  private KernelThreadPin() {}

  /**
   * What pins a virtual thread is in a package of the JDK that is not exported. It can be exported
   * by what is in {@code java.lang}, which is open where the tick loop runs the jobs itself; where
   * it is not, jobs do not let others run unless they say so.
   */
  private static @Nullable MethodHandle find(String name) {
    try {
      Method export = Module.class.getDeclaredMethod("implAddExportsToAllUnnamed", String.class);
      export.setAccessible(true);
      export.invoke(Object.class.getModule(), "jdk.internal.vm");
      return MethodHandles.lookup()
          .findStatic(
              Class.forName("jdk.internal.vm.Continuation"),
              name,
              MethodType.methodType(void.class));
    } catch (ReflectiveOperationException | RuntimeException e) {
      return null;
    }
  }

  /** From now on the job does not leave the kernel thread; to be called by the job. */
  public static void pin() {
    if (PIN != null) {
      try {
        PIN.invokeExact();
      } catch (Throwable e) {
        throw new IllegalStateException(e);
      }
    }
  }

  /** Ends what {@link #pin} began. */
  public static void unpin() {
    if (UNPIN != null) {
      try {
        UNPIN.invokeExact();
      } catch (Throwable e) {
        throw new IllegalStateException(e);
      }
    }
  }
}

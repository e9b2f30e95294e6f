package org.urbi.kernel.job;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Method;
import org.jspecify.annotations.Nullable;

/**
 * Keeps a job on the kernel thread, except where it lets others run. If its code waits in Java, the
 * kernel waits with it, as the manual has it for components ("Asynchronous binding"). Without the
 * pin, the virtual thread of the job would be unmounted and other jobs would run.
 */
final class KernelThreadPin {
  private static final @Nullable MethodHandle PIN = find("pin");
  private static final @Nullable MethodHandle UNPIN = find("unpin");

  private KernelThreadPin() {}

  /**
   * The method that pins a virtual thread is in a package that the JDK does not export. Reflection
   * in {@code java.lang} can export it; that package is open where the tick loop itself runs the
   * jobs. Where it is not open, no pin is needed: a job lets others run only when it says so.
   */
  private static @Nullable MethodHandle find(String name) {
    try {
      Method export = Module.class.getDeclaredMethod("implAddExportsToAllUnnamed", String.class);
      export.setAccessible(true);
      MethodHandles.Lookup lookup = MethodHandles.lookup();
      lookup.unreflect(export).invokeExact(Object.class.getModule(), "jdk.internal.vm");
      return lookup.findStatic(
          Class.forName("jdk.internal.vm.Continuation"), name, MethodType.methodType(void.class));
    } catch (ReflectiveOperationException | RuntimeException e) {
      return null;
    } catch (Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(e);
    }
  }

  /** Whether a job can be pinned. */
  static boolean isAvailable() {
    return PIN != null && UNPIN != null;
  }

  /** Pins the running job to the kernel thread. */
  static void pin() {
    if (PIN != null) {
      try {
        PIN.invokeExact();
      } catch (RuntimeException | Error e) {
        throw e;
      } catch (Throwable e) {
        throw new IllegalStateException(e);
      }
    }
  }

  /** Ends what {@link #pin} began. */
  static void unpin() {
    if (UNPIN != null) {
      try {
        UNPIN.invokeExact();
      } catch (RuntimeException | Error e) {
        throw e;
      } catch (Throwable e) {
        throw new IllegalStateException(e);
      }
    }
  }
}

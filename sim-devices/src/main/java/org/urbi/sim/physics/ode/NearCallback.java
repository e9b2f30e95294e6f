package org.urbi.sim.physics.ode;

import static java.lang.foreign.ValueLayout.JAVA_LONG;

import java.lang.foreign.Arena;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemorySegment;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import org.jspecify.annotations.Nullable;

/**
 * ODE's {@code dNearCallback}: a function of C that calls Java. It is there as long as this object.
 */
final class NearCallback {
  /** Takes two shapes that are near each other, as ODE names them. */
  @FunctionalInterface
  interface Pairs {
    void near(long firstGeom, long secondGeom);
  }

  private static final FunctionDescriptor TYPE =
      FunctionDescriptor.ofVoid(JAVA_LONG, JAVA_LONG, JAVA_LONG);

  private final Pairs pairs;
  private final MemorySegment stub;
  private @Nullable Throwable failure;

  @SuppressWarnings("restricted") // The type is that of ODE's header.
  NearCallback(Pairs pairs) {
    this.pairs = pairs;
    try {
      MethodHandle method =
          MethodHandles.lookup()
              .findVirtual(
                  NearCallback.class,
                  "near",
                  MethodType.methodType(void.class, long.class, long.class, long.class));
      stub = Linker.nativeLinker().upcallStub(method.bindTo(this), TYPE, Arena.ofAuto());
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Where the function is. */
  long address() {
    return stub.address();
  }

  /** What C calls. Nothing may be thrown through its frames: that would end the process. */
  private void near(long data, long firstGeom, long secondGeom) {
    try {
      if (failure == null) {
        pairs.near(firstGeom, secondGeom);
      }
    } catch (Throwable e) {
      failure = e;
    }
  }

  /** Throws what was thrown during the call; after it. */
  void check() {
    Throwable thrown = failure;
    failure = null;
    switch (thrown) {
      case null -> {}
      case RuntimeException e -> throw e;
      case Error e -> throw e;
      default -> throw new IllegalStateException(thrown);
    }
  }
}

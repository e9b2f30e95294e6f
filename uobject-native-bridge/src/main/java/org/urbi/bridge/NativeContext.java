package org.urbi.bridge;

import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import urbi.UContext;
import urbi.UEmitter;

/** The state of one module in one context. C++ code refers to it by a number. */
final class NativeContext {
  private static final HandleTable<NativeContext> ALL = new HandleTable<>();

  private final NativeModule module;
  private final UContext context;
  private final long number;

  final HandleTable<NativeInstance> residents = new HandleTable<>();
  final HandleTable<NativeVariable> variables = new HandleTable<>();
  final HandleTable<UEmitter> events = new HandleTable<>();
  final HandleTable<Runnable> timers = new HandleTable<>();

  NativeContext(NativeModule module, UContext context) {
    this.module = module;
    this.context = context;
    this.number = ALL.add(this);
  }

  /** The one of that number, or null. */
  static @Nullable NativeContext find(long number) {
    return ALL.find(number);
  }

  NativeModule module() {
    return module;
  }

  UContext context() {
    return context;
  }

  long number() {
    return number;
  }

  /** Executes code of the module, on the thread for native code that yields if it does. */
  <T> T execute(Supplier<T> code) {
    if (!module.yields()) {
      return code.get();
    }
    return context.executeNative(NativeFrames.holdJob() ? () -> NativeFrames.held(code) : code);
  }

  /** Deletes the hubs: nobody else does. */
  void endHubs() {
    for (NativeInstance each : residents.all()) {
      if (each.javaSide() instanceof NativeHub hub) {
        hub.close();
      }
    }
  }

  /**
   * Ends the use of the context.
   *
   * @return whether the threads that the module has made for it have ended
   */
  boolean close() {
    boolean ended;
    CallFrame frame = CallFrame.take();
    try {
      frame.prepare(0, number, 0);
      ended = module.entries().forget(frame.exchange) == 1;
    } finally {
      frame.release(module.entries());
    }
    ALL.remove(number);
    return ended;
  }
}

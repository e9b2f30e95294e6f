package org.urbi.bridge;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.Collections;
import urbi.LockMode;
import urbi.LockSpec;
import urbi.UCallback;
import urbi.UContext;
import urbi.UValue;

/** A member function of a C++ object, as contexts call it. */
final class NativeCallback {
  private static final UValue[] NONE = {};
  private static final LockMode[] MODES = LockMode.values();
  private static final MethodHandle CALL;
  private static final MethodHandle CALL_WITHOUT;
  private static final MethodHandle CALL_WITH_ONE;

  static {
    try {
      MethodHandles.Lookup lookup = MethodHandles.lookup();
      CALL =
          lookup.findVirtual(
              NativeCallback.class, "call", MethodType.methodType(UValue.class, UValue[].class));
      CALL_WITHOUT =
          lookup.findVirtual(NativeCallback.class, "call", MethodType.methodType(UValue.class));
      CALL_WITH_ONE =
          lookup.findVirtual(
              NativeCallback.class, "call", MethodType.methodType(UValue.class, UValue.class));
    } catch (ReflectiveOperationException e) {
      throw new ExceptionInInitializerError(e);
    }
  }

  private final NativeInstance owner;
  private final String name;
  private final long address;
  private final ModuleFunctions entries;
  private final long context;
  private final boolean yields;

  private NativeCallback(NativeInstance owner, String name, long address) {
    this.owner = owner;
    this.name = name;
    this.address = address;
    this.entries = owner.in().module().entries();
    this.context = owner.in().number();
    this.yields = owner.in().module().yields();
  }

  /**
   * Reads a callback among the arguments of a request.
   *
   * @param name by which errors call it
   * @param what which threaded calls exclude one another, if those of one function do
   */
  static UCallback read(ValueReader in, NativeInstance owner, String name, String what) {
    long address = in.rawLong();
    int arity = (int) in.rawLong();
    int mode = (int) in.rawLong();
    int most = (int) in.rawLong();
    var callback = new NativeCallback(owner, name, address);
    UCallback made =
        UCallback.of(name, callback.handle(arity), Collections.nCopies(arity, UValue.class));
    if (mode < 0) {
      return arity == 0 ? made.uncopied(callback.handle(1)) : made;
    }
    LockSpec lock = new LockSpec(MODES[mode], most);
    return made.threaded(lock, owner.queue(lock.lockMode(), what));
  }

  private MethodHandle handle(int arity) {
    return switch (arity) {
      case 0 -> CALL_WITHOUT.bindTo(this);
      case 1 -> CALL_WITH_ONE.bindTo(this);
      default -> CALL.bindTo(this).asCollector(UValue[].class, arity);
    };
  }

  private UValue call() {
    return call(NONE);
  }

  private UValue call(UValue argument) {
    return call(new UValue[] {argument});
  }

  private UValue call(UValue... arguments) {
    return yields ? owner.in().execute(() -> callHere(arguments)) : callHere(arguments);
  }

  private UValue callHere(UValue... arguments) {
    if (!owner.enter()) {
      throw new NativeException(name + " has been destroyed");
    }
    CallFrame frame = CallFrame.take();
    UContext before = UContext.enter(owner.in().context());
    NativeFrames frames = NativeFrames.enter();
    try {
      for (UValue argument : arguments) {
        frame.arguments.value(argument);
      }
      frame.prepare(0, context, address);
      if (entries.invoke(frame.exchange) == Exchange.FAILED) {
        throw frame.failure();
      }
      return frame.reply().value();
    } finally {
      frames.leave();
      UContext.enter(before);
      frame.release(entries);
      owner.leave();
    }
  }
}

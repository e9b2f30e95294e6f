package org.urbi.kernel.remote;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.uobject.Reclaimable;
import urbi.UCallback;
import urbi.UObject;
import urbi.UValue;

/** The kernel's representation of a UObject of another process, where its functions are called. */
public final class RemoteObject extends UObject implements AutoCloseable, Reclaimable {
  private static final MethodHandle CALL;

  static {
    try {
      CALL =
          MethodHandles.lookup()
              .findVirtual(
                  RemoteObject.class,
                  "call",
                  MethodType.methodType(CompletionStage.class, String.class, UValue[].class));
    } catch (ReflectiveOperationException e) {
      throw new ExceptionInInitializerError(e);
    }
  }

  private final RemoteProcess process;
  private final Map<String, Integer> arities = new HashMap<>();

  /**
   * @param process the process that has the object
   */
  public RemoteObject(RemoteProcess process, String name) {
    super(name);
    this.process = process;
  }

  /** Binds a function of the process to the urbiscript object. */
  public void bindRemote(String function, int arity) {
    Integer known = arities.put(function, arity);
    if (known == null || known != arity) {
      MethodHandle handle =
          MethodHandles.insertArguments(CALL.bindTo(this), 0, function)
              .asCollector(UValue[].class, arity);
      bind(function, UCallback.of(get__name() + "." + function, handle));
    }
  }

  /** Binds the same functions as another object of the class. */
  void bindLike(RemoteObject other) {
    other.arities.forEach(this::bindRemote);
  }

  CompletionStage<UValue> call(String function, UValue... arguments) {
    return process.call(get__name(), function, arguments);
  }

  @Override
  public @Nullable String reclaimReason() {
    return process.lost();
  }

  @Override
  public void close() {
    process.gone(this);
  }
}

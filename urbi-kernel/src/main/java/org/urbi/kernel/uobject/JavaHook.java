package org.urbi.kernel.uobject;

import static java.util.Objects.requireNonNull;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodType;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.variable.Datum;
import org.urbi.kernel.variable.Hook;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.UCallback;
import urbi.UCast;

/** Calls a function of a UObject when a variable changes, or is read. */
final class JavaHook implements Hook {
  private static final UrbiObject[] NONE = {};

  private final PluggedContext context;
  private final UCallback callback;
  private final CallStatistics.Entry statistics;

  /** Converts the urbiscript value, if the function takes it, and calls the function. */
  private final @Nullable MethodHandle whole;

  /** Converts a value that was not copied, and calls the function; null if it takes none. */
  private final @Nullable MethodHandle uncopied;

  JavaHook(PluggedContext context, UCallback callback) {
    this.context = context;
    this.callback = callback;
    this.whole = callback.isThreaded() ? null : context.converters().whole(callback);
    this.uncopied = uncopied(callback);
    this.statistics = context.statistics().entry(callback.name());
  }

  private static @Nullable MethodHandle uncopied(UCallback callback) {
    MethodHandle taken = callback.arity() == 1 ? callback.handle() : callback.uncopied();
    return taken == null ? null : taken.asType(MethodType.genericMethodType(1));
  }

  @Override
  public void run(Frame frame, UrbiUVar variable, Datum value) {
    Frame outer = context.crossing().leave(frame, callback.name());
    long started = statistics.begin();
    try {
      if (callback.isThreaded()) {
        Object[] arguments = arguments(value);
        context.jobs().runThreaded(callback, () -> callThreaded(arguments));
      } else {
        context.notifications().begin(frame.job(), variable, value);
        try {
          call(value);
        } finally {
          context.notifications().end(frame.job(), variable, value);
        }
      }
    } catch (Throwable e) {
      throw failure(frame, e);
    } finally {
      statistics.end(started);
      context.crossing().back(frame, outer);
    }
  }

  private void call(Datum value) throws Throwable {
    if (uncopied != null && value.foreign() instanceof BypassValue foreign) {
      Object given =
          callback.arity() == 0
              ? foreign.value()
              : UCast.to(foreign.value(), callback.parameterTypes().getFirst());
      Object ignored = uncopied.invokeExact(given);
      return;
    }
    UrbiObject[] arguments = callback.arity() == 0 ? NONE : new UrbiObject[] {value.value()};
    UrbiObject ignored =
        (UrbiObject) requireNonNull(whole, "it is not threaded").invokeExact(arguments);
  }

  private Object[] arguments(Datum value) throws Throwable {
    if (callback.arity() == 0) {
      return new Object[0];
    }
    if (value.foreign() instanceof BypassValue foreign) {
      return new Object[] {UCast.to(foreign.copied(), callback.parameterTypes().getFirst())};
    }
    return new Object[] {context.converters().argument(callback, 0, value.value())};
  }

  private void callThreaded(Object[] arguments) {
    try {
      callback.call(arguments);
    } catch (Throwable e) {
      context.reportUnlessOver(message(e));
    }
  }

  private RuntimeException failure(Frame frame, Throwable e) {
    return switch (e) {
      case ControlFlowException unwinding -> unwinding;
      case UrbiException thrown -> thrown;
      case PropagatedUrbiException raised -> raised.original();
      default ->
          frame
              .interpreter()
              .errors()
              .primitive(callback.name(), Problem.REASON, Utf8Text.toUrbi(message(e)));
    };
  }

  private String message(Throwable e) {
    String doing = JavaFailures.calling(callback.name());
    return e instanceof ConversionFailure failure && failure.getMessage() == null
        ? Problem.CAUGHT_IN_COMPONENT.text(
            doing, Problem.NO_VALUE_OF_TYPE.text(String.valueOf(failure.expected())))
        : JavaFailures.caught(doing, e);
  }
}

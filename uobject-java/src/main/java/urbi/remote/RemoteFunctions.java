package urbi.remote;

import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import urbi.UCallback;
import urbi.UCast;
import urbi.UCastException;
import urbi.UClientException;
import urbi.UValue;
import urbi.spi.ArgumentException;
import urbi.spi.ArgumentTypes;
import urbi.spi.ComponentFailureLog;
import urbi.spi.Failure;
import urbi.wire.Frame;

/** The functions that UObjects have bound, and their calls: by the kernel, and as callbacks. */
final class RemoteFunctions {
  private final RemoteContext context;
  private final ComponentFailureLog failureLog;
  private final SlowCallMonitor turn;
  private final Map<String, Map<String, UCallback>> functions = new ConcurrentHashMap<>();

  /**
   * @param failureLog where the stack traces of what they throw go
   * @param turn measures those that are called in turn
   */
  RemoteFunctions(RemoteContext context, ComponentFailureLog failureLog, SlowCallMonitor turn) {
    this.context = context;
    this.failureLog = failureLog;
    this.turn = turn;
  }

  /** Keeps a function of an object. */
  void bind(String owner, String name, UCallback function) {
    functions.computeIfAbsent(owner, key -> new ConcurrentHashMap<>()).put(name, function);
  }

  /** Forgets those of an object. */
  void forget(String owner) {
    functions.remove(owner);
  }

  private @Nullable UCallback function(String object, String name) {
    Map<String, UCallback> all = functions.get(object);
    return all == null ? null : all.get(name);
  }

  /** The kernel calls one. */
  void call(int number, String object, String name, UValue[] arguments) {
    Consumer<String> told = context.trace();
    if (told != null) {
      told.accept("call " + number + ": " + object + "." + name + Arrays.asList(arguments));
    }
    UCallback known = function(object, name);
    if (known != null && known.isThreaded()) {
      Runnable call = () -> context.execute(() -> perform(known, number, arguments));
      if (!known.execute(context, call)) {
        result(number, null);
      }
    } else {
      context.later(() -> perform(number, object, name, arguments));
    }
  }

  private void perform(int number, String object, String name, UValue[] arguments) {
    UCallback function = function(object, name);
    if (function != null) {
      turn.begin(function.name());
      perform(function, number, arguments);
      turn.end();
    } else {
      error(number, context.failure(object, "no function " + object + "." + name));
    }
  }

  private void perform(UCallback function, int number, UValue[] arguments) {
    try {
      Object result = invoke(function, arguments);
      if (result instanceof CompletionStage<?> stage) {
        stage.whenComplete((value, failure) -> {
          if (failure == null) {
            result(number, value);
          } else {
            failureLog.log(function.name(), failure);
            error(number, Failure.text(failure));
          }
        });
      } else {
        result(number, result);
      }
    } catch (ArgumentException e) {
      context.sendNow(out ->
          out.begin(Frame.ARGUMENT_ERROR).size(number).size(e.place()).text(e.expected()).end());
    } catch (Throwable e) {
      failureLog.log(function.name(), e);
      error(number, Failure.text(e));
    }
  }

  private static Object invoke(UCallback function, UValue... arguments) throws Throwable {
    Object[] converted = new Object[function.arity()];
    if (arguments.length != converted.length) {
      throw new IllegalArgumentException(
          function.name()
              + ": expected "
              + converted.length
              + " arguments, given "
              + arguments.length);
    }
    for (int i = 0; i < converted.length; i++) {
      converted[i] = argument(arguments[i], i, function.parameterTypes().get(i));
    }
    return function.call(converted);
  }

  private static @Nullable Object argument(UValue value, int index, Type type) {
    try {
      return UCast.to(value, type);
    } catch (UCastException e) {
      String expected = ArgumentTypes.name(type);
      throw expected == null ? e : new ArgumentException(index + 1, expected, e);
    }
  }

  /** Answers a call. */
  void result(int number, @Nullable Object result) {
    try {
      UValue value = UCast.toUValue(result);
      context.sendNow(out -> out.begin(Frame.RESULT).size(number).value(value).end());
    } catch (UClientException e) {
      throw e;
    } catch (RuntimeException e) {
      failureLog.log("the result of a function", e);
      error(number, Failure.text(e));
    }
  }

  private void error(int number, String text) {
    Consumer<String> told = context.trace();
    if (told != null) {
      told.accept("call " + number + " has failed: " + text);
    }
    context.sendNow(out -> out.begin(Frame.ERROR).size(number).text(text).end());
  }

  /** Tells a callback of a value, in turn or on its own thread. */
  void notify(UCallback callback, UValue value) {
    if (callback.isThreaded()) {
      notifyNow(callback, value);
    } else {
      context.later(() -> notifyInTurn(callback, value));
    }
  }

  /** Tells a callback of a value, as a call of its own on the thread that calls UObjects. */
  void notifyInTurn(UCallback callback, UValue value) {
    callBackInTurn(callback, arguments(callback, value));
  }

  /** Tells a callback of a value in the middle of what is called, or on its own thread. */
  void notifyNow(UCallback callback, UValue value) {
    UValue[] arguments = arguments(callback, value);
    if (callback.isThreaded()) {
      callback.execute(context, () -> callBack(callback, arguments));
    } else {
      callBack(callback, arguments);
    }
  }

  private static UValue[] arguments(UCallback callback, UValue value) {
    return callback.arity() == 0 ? new UValue[0] : new UValue[] {value};
  }

  /** Calls one of which nobody waits for the result; on the thread that calls UObjects. */
  void callBackInTurn(UCallback callback, UValue... arguments) {
    turn.begin(callback.name());
    callBack(callback, arguments);
    turn.end();
  }

  private void callBack(UCallback callback, UValue... arguments) {
    try {
      invoke(callback, arguments);
    } catch (Throwable e) {
      failureLog.log(callback.name(), e);
      context.complain(
          "exception caught while calling " + callback.name() + ": " + Failure.text(e));
    }
  }
}

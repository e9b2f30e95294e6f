package urbi;

import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;

/** The common base of {@link UObject} and {@link UObjectHub}: objects that live in a context. */
public abstract sealed class UObjectBase permits UObject, UObjectHub {
  private static final double MILLISECOND_NANOSECONDS = 1e6;

  private final UContext context;
  private final Map<String, Runnable> timers = new ConcurrentHashMap<>();
  private final AtomicInteger lastTimer = new AtomicInteger();
  private final AtomicReference<Runnable> updates = new AtomicReference<>();

  UObjectBase(UContext context) {
    this.context = context;
  }

  /** The context in which it lives. */
  public final UContext getUContext() {
    return context;
  }

  /** The name of the object in error messages. */
  abstract String shownName();

  // ------------------------------------------------------------------ how it runs

  /** Whether it runs in the process of the kernel, or in another one. */
  public final UObjectMode getRunningMode() {
    return context.getRunningMode();
  }

  public final boolean isPluginMode() {
    return getRunningMode() == UObjectMode.MODE_PLUGIN;
  }

  public final boolean isRemoteMode() {
    return getRunningMode() == UObjectMode.MODE_REMOTE;
  }

  /** The object of that name that lives in the same context, or null. */
  public @Nullable UObject getUObject(String objectName) {
    return context.getUObject(objectName);
  }

  /** The hub of that class, or null (manual, "Using hubs to group objects"). */
  public @Nullable UObjectHub getUObjectHub(String className) {
    return context.getUObjectHub(className);
  }

  // ------------------------------------------------------------------ urbiscript

  /** Executes urbiscript code, as if a client had sent it (manual, "Sending urbi code"). */
  public void send(String code) {
    context.send(code);
  }

  /** Executes urbiscript code that is given as bytes. */
  public void send(byte[] code, int size) {
    send(new String(Arrays.copyOf(code, size), StandardCharsets.UTF_8));
  }

  /**
   * Calls a function of an urbiscript object, later; the result is dropped.
   *
   * @param object the name of an object
   * @param arguments made values by {@link UCast#toUValue}
   */
  public void call(String object, String method, Object... arguments) {
    UValue[] values = new UValue[arguments.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = UCast.toUValue(arguments[i]);
    }
    context.call(object, method, values);
  }

  // ------------------------------------------------------------------ time

  /** Lets other code run until the next cycle of the kernel; in Java it is {@code this.yield()}. */
  public void yield() {
    context.yieldFor(Duration.ZERO);
  }

  /** Lets other code run for that many microseconds. */
  public void yield_for(long microseconds) {
    context.yieldFor(Duration.ofNanos(microseconds * 1000));
  }

  /**
   * Has {@link #update} called periodically, just after a pass of urbiscript code (manual,
   * "Timers").
   *
   * @param period in milliseconds; -1 for never
   */
  public void USetUpdate(double period) {
    Runnable next = null;
    if (period >= 0) {
      Method method = Methods.find(UObjectBase.class, "update");
      UCallback callback = Methods.callback(shownName() + ".update", this, method);
      next = context.every(this, period, callback, true);
    }
    Runnable before = updates.getAndSet(next);
    if (before != null) {
      before.run();
    }
  }

  /**
   * Called periodically when {@link #USetUpdate} asked for it.
   *
   * @return does not matter
   */
  public int update() {
    return 0;
  }

  /** Calls {@code update} periodically, as {@link #USetUpdate(double)} does. */
  public void USetUpdate(Duration period) {
    USetUpdate(period.toNanos() / MILLISECOND_NANOSECONDS);
  }

  /**
   * Calls a method without arguments periodically, just before a pass of urbiscript code.
   *
   * @param period in milliseconds
   * @param object which has the method
   * @return the name of the timer, for {@link #removeTimer}
   */
  public String USetTimer(double period, Object object, String methodName) {
    return setTimer(period, object, Methods.find(object.getClass(), methodName));
  }

  /** Calls a method of an object periodically, which is found by the types of its parameters. */
  public String USetTimer(double period, Object object, String methodName, String[] argumentTypes) {
    return setTimer(period, object, Methods.find(object.getClass(), methodName, argumentTypes));
  }

  /** Calls that method of an object periodically. */
  public String USetTimer(double period, Object object, Method method) {
    return setTimer(period, object, method);
  }

  /** Runs an action periodically, just before a pass of urbiscript code. */
  public String USetTimer(Duration period, Runnable action) {
    return USetTimer(period.toNanos() / MILLISECOND_NANOSECONDS, action, "run");
  }

  private String setTimer(double period, Object object, Method method) {
    return setTimer(period, object, method, false);
  }

  String setTimer(double period, Object object, Method method, boolean afterPass) {
    String name = shownName() + "." + method.getName();
    if (method.getParameterCount() > 0) {
      throw new IllegalArgumentException(name + " is for a timer, but has arguments");
    }
    UCallback callback = Methods.callback(name, object, method);
    String handle = shownName() + ".timer" + lastTimer.incrementAndGet();
    timers.put(handle, context.every(this, period, callback, afterPass));
    return handle;
  }

  /** Ends a timer; false if it has none of that name, or no longer. */
  public boolean removeTimer(TimerHandle handle) {
    return removeTimer(handle.name());
  }

  /** Ends a timer; false if it has none of that name, or no longer. */
  public boolean removeTimer(String handle) {
    Runnable end = timers.remove(handle);
    if (end == null) {
      return false;
    }
    end.run();
    return true;
  }
}

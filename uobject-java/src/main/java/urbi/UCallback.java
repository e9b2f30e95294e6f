package urbi;

import java.lang.invoke.MethodHandle;
import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A function that a context calls: the method of an object, or whatever a method handle can be. Its
 * arguments are of any types to which a {@link UValue} can be converted ({@link UCast}), {@link
 * UVar} and subclasses of {@link UObject} included.
 */
public final class UCallback {
  private final String name;
  private final MethodHandle handle;
  private final List<Type> parameterTypes;
  private final @Nullable MethodHandle uncopied;
  private final @Nullable LockSpec lock;
  private final @Nullable UTaskQueue queue;

  private UCallback(
      String name,
      MethodHandle handle,
      List<Type> parameterTypes,
      @Nullable MethodHandle uncopied,
      @Nullable LockSpec lock,
      @Nullable UTaskQueue queue) {
    this.name = Objects.requireNonNull(name, "name");
    this.handle = handle;
    this.parameterTypes = parameterTypes;
    this.uncopied = uncopied;
    this.lock = lock;
    this.queue = queue;
  }

  /**
   * A function that is called synchronously.
   *
   * @param name by which errors call it
   * @param handle with nothing but the arguments of the call left to be given
   */
  public static UCallback of(String name, MethodHandle handle) {
    return of(name, handle, List.of(handle.type().parameterArray()));
  }

  /**
   * A function that is called synchronously.
   *
   * @param parameterTypes what its arguments are, where more is known than classes
   */
  public static UCallback of(
      String name, MethodHandle handle, List<? extends Type> parameterTypes) {
    if (handle.type().parameterCount() != parameterTypes.size()) {
      throw new IllegalArgumentException(name + ": " + parameterTypes + " for " + handle.type());
    }
    return new UCallback(
        name, handle.asFixedArity(), List.copyOf(parameterTypes), null, null, null);
  }

  /**
   * The same function, to be called on a thread of its own.
   *
   * @param queue the calls that exclude this one; null for none
   */
  public UCallback threaded(LockSpec spec, @Nullable UTaskQueue queue) {
    return new UCallback(name, handle, parameterTypes, null, spec, queue);
  }

  /**
   * The same function, which gets values that were not copied (manual, "0-copy mode") even if it
   * has no parameter for them: it need not ask for the value.
   *
   * @param told what is called with such a {@link UValue}
   */
  public UCallback uncopied(MethodHandle told) {
    return new UCallback(name, handle, parameterTypes, told, lock, queue);
  }

  /**
   * What is called with a value that was not copied, if that is not {@link #handle}; null if it is.
   */
  public @Nullable MethodHandle uncopied() {
    return uncopied;
  }

  /** By which errors call it. */
  public String name() {
    return name;
  }

  /** What is called; the types of its arguments are those of {@link #parameterTypes}. */
  public MethodHandle handle() {
    return handle;
  }

  /** How many arguments it has. */
  public int arity() {
    return parameterTypes.size();
  }

  public List<Type> parameterTypes() {
    return parameterTypes;
  }

  /** Whether it is called on a thread of its own. */
  public boolean isThreaded() {
    return lock != null;
  }

  /** How it is locked; null if it is not {@linkplain #isThreaded threaded}. */
  public @Nullable LockSpec lock() {
    return lock;
  }

  /** The calls that exclude this one; null for none. */
  public @Nullable UTaskQueue queue() {
    return queue;
  }

  /**
   * Calls the function, threaded or not.
   *
   * @return null for {@code void}
   * @throws Throwable what the function throws
   */
  public Object call(Object... arguments) throws Throwable {
    return handle.invokeWithArguments(arguments);
  }

  /**
   * Runs a threaded call on a thread, when its lock lets it.
   *
   * @return false if it was dropped, because too many wait
   */
  public boolean execute(UContext context, Runnable task) {
    Runnable entered =
        () -> {
          UContext before = UContext.enter(context);
          try {
            task.run();
          } finally {
            UContext.enter(before);
          }
        };
    if (queue == null || lock == null) {
      context.threads().execute(entered);
      return true;
    }
    return queue.execute(context.threads(), lock.maxQueueSize(), entered);
  }

  @Override
  public String toString() {
    return name + Arrays.toString(parameterTypes.toArray());
  }
}

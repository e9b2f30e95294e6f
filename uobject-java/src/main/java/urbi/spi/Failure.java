package urbi.spi;

import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import urbi.UCastException;

/** Describes an exception in the code of a UObject, for users. */
public final class Failure {
  private Failure() {}

  /** What a UObject threw, without what it was wrapped in. */
  public static Throwable cause(Throwable failure) {
    Throwable cause = failure;
    while (cause.getCause() != null
        && (cause instanceof CompletionException
            || cause instanceof ExecutionException
            || cause instanceof InvocationTargetException)) {
      cause = cause.getCause();
    }
    return cause;
  }

  /** What a UObject threw, for people. */
  public static String text(Throwable failure) {
    Throwable cause = cause(failure);
    if (cause instanceof StackOverflowError) {
      return "stack space exhausted";
    }
    String message = cause.getMessage();
    if (cause instanceof NoClassDefFoundError && message != null) {
      return "missing class " + message.replace('/', '.');
    }
    if (message == null || message.isEmpty()) {
      return cause.getClass().getSimpleName();
    }
    boolean plain =
        cause.getClass() == RuntimeException.class
            || cause.getClass() == Exception.class
            || cause instanceof IllegalStateException
            || cause instanceof IllegalArgumentException
            || cause instanceof ArgumentException
            || cause instanceof UCastException;
    return plain ? message : cause.getClass().getSimpleName() + ": " + message;
  }
}

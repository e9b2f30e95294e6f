package urbi.spi;

import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import urbi.UCastException;
import urbi.UClientException;
import urbi.UConversionException;
import urbi.UModuleException;

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

  /**
   * Whether nobody but us can have caused the failure of what others have asked for. What the
   * kernel refuses, what urbiscript throws and what ends a job has no Java stack trace, or is of a
   * class that says what is wrong.
   */
  public static boolean isDefect(Throwable failure) {
    return switch (failure) {
      case StackOverflowError e -> false;
      case Error e -> true;
      case IllegalArgumentException e -> false;
      case IllegalStateException e -> false;
      case UCastException e -> false;
      case UClientException e -> false;
      case UConversionException e -> false;
      case UModuleException e -> false;
      case InterruptedException e -> false;
      default -> failure.getStackTrace().length > 0;
    };
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

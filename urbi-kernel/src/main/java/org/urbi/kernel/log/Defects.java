package org.urbi.kernel.log;

import urbi.UCastException;
import urbi.UClientException;
import urbi.UConversionException;
import urbi.UModuleException;
import urbi.wire.WireException;

/** Tells a bug of ours from what a component, or a remote process, has itself to answer for. */
public final class Defects {
  private Defects() {}

  /**
   * Whether nobody but us can have caused a failure. What the kernel refuses, what urbiscript
   * throws and what ends a job has no Java stack trace, or is of a class that says what is wrong.
   */
  public static boolean isDefect(Throwable failure) {
    return switch (failure) {
      case StackOverflowError e -> false;
      case OutOfMemoryError e -> false;
      case Error e -> true;
      case IllegalArgumentException e -> false;
      case IllegalStateException e -> false;
      case UCastException e -> false;
      case UClientException e -> false;
      case UConversionException e -> false;
      case UModuleException e -> false;
      case WireException e -> false;
      default -> failure.getStackTrace().length > 0;
    };
  }

  /**
   * Logs a bug of ours with its stack, and nothing else.
   *
   * @param where the part of the kernel that failed
   */
  public static void log(String where, Throwable failure) {
    if (isDefect(failure)) {
      FailureLog.internal(where, failure);
    }
  }

  /**
   * What those are told whose request has failed; a bug of ours is logged with its stack.
   *
   * @param where the part of the kernel that failed
   */
  public static String text(String where, Throwable failure) {
    log(where, failure);
    if (isDefect(failure)) {
      return FailureLog.text(failure);
    }
    String message = failure.getMessage();
    return message == null ? failure.toString() : message;
  }
}

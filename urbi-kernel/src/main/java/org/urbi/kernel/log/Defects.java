package org.urbi.kernel.log;

import urbi.spi.Failure;
import urbi.wire.WireException;

/** Tells a bug of ours from what a component, or a remote process, has itself to answer for. */
public final class Defects {
  private Defects() {}

  /** Whether nobody but us can have caused a failure; whoever fills the memory can. */
  public static boolean isDefect(Throwable failure) {
    return !(failure instanceof OutOfMemoryError)
        && !(failure instanceof WireException)
        && Failure.isDefect(failure);
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

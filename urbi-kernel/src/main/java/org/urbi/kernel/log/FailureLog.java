package org.urbi.kernel.log;

import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.urbi.kernel.error.Problem;

/**
 * Keeps the stack traces of what went wrong in Java: of failures of our own, of which urbiscript is
 * told as <em>internal error</em> and no more, and of components.
 *
 * <p>They go to the SLF4J logger {@code urbi.kernel}. It is looked for when there is something to
 * write, and not before: that takes longer than a short script.
 */
public final class FailureLog {
  private static final String LOGGER = "urbi.kernel";

  private FailureLog() {}

  /** What those are told whom a failure of our own concerns. */
  public static String text(Throwable failure) {
    return Problem.INTERNAL_ERROR.text(failure);
  }

  /**
   * Logs a failure of our own.
   *
   * @param where the part of the kernel that failed
   */
  public static void internal(String where, Throwable failure) {
    write("internal error in " + where, failure);
  }

  /**
   * Logs what a component has thrown.
   *
   * @param doing what was being done for the component
   */
  public static void component(String doing, Throwable failure) {
    write("exception caught while " + doing, failure);
  }

  private static void write(String message, Throwable failure) {
    try {
      Logger logger = LoggerFactory.getLogger(LOGGER);
      logger.error(message, failure);
    } catch (Throwable unable) {
      // Memory is exhausted, or the log is broken: whoever failed goes on all the same.
      System.err.println("urbi: " + message + ": " + failure + " (the log fails: " + unable + ")");
    }
  }

  /** Runs something on a thread of its own, where nobody sees what it throws. */
  public static Runnable guarding(String where, Runnable task) {
    return () -> {
      try {
        task.run();
      } catch (Throwable failure) {
        internal(where, failure);
      }
    };
  }
}

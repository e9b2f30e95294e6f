package org.urbi.kernel.log;

import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.urbi.kernel.error.Problem;
import urbi.thread.GuardedThreads;

/**
 * Logs the stack traces of Java failures: of bugs of ours, which urbiscript only sees as
 * <em>internal error</em>, and of components.
 *
 * <p>They go to the SLF4J logger {@code urbi.kernel}. The logger is created when there is something
 * to log: creating it takes longer than a short script.
 */
public final class FailureLog {
  private static final String LOGGER = "urbi.kernel";

  /** The threads of kernels, and of the programs around them: what ends one is logged here. */
  public static final GuardedThreads THREADS = new GuardedThreads(FailureLog::internal);

  private FailureLog() {}

  /** The message about a bug of ours for those whom it affects. */
  public static String text(Throwable failure) {
    return Problem.INTERNAL_ERROR.text(failure);
  }

  /**
   * Logs a bug of ours.
   *
   * @param where the part of the kernel that failed
   */
  public static void internal(String where, Throwable failure) {
    write("internal error in " + where, failure);
  }

  /**
   * Logs what a component has thrown.
   *
   * @param doing the activity that failed
   */
  public static void component(String doing, Throwable failure) {
    write("exception caught while " + doing, failure);
  }

  private static void write(String message, Throwable failure) {
    try {
      Logger logger = LoggerFactory.getLogger(LOGGER);
      logger.error(message, failure);
    } catch (Throwable unable) {
      // Memory is exhausted, or the log is broken: the failed code must continue all the same.
      System.err.println("urbi: " + message + ": " + failure + " (the log fails: " + unable + ")");
    }
  }
}

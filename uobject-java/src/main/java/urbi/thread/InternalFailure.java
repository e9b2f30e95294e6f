package urbi.thread;

import java.lang.System.Logger.Level;

/** A defect of ours in the process of a component or a client. */
public final class InternalFailure {
  private static final String CATEGORY = "UObjectJava";

  private InternalFailure() {}

  /** What those are told whom it concerns. */
  public static String text(Throwable failure) {
    return "internal error: " + failure;
  }

  /**
   * Writes it to the log of the process, with its stack.
   *
   * @param where the part of the program that failed
   */
  public static void log(String where, Throwable failure) {
    String message = "internal error in " + where;
    try {
      System.getLogger(CATEGORY).log(Level.ERROR, message, failure);
    } catch (Throwable unable) {
      // Memory is exhausted, or the log is broken: what has failed is dealt with all the same.
      System.err.println("urbi: " + message + ": " + failure + " (the log fails: " + unable + ")");
    }
  }
}

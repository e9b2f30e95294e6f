package urbi;

import java.lang.System.Logger.Level;

/**
 * Messages for whoever runs a component, not for urbiscript: they go to the log of the process, as
 * {@link System.Logger} has it, under the name of their category.
 */
public final class Log {
  private static final String CATEGORY = "UObjectJava";

  private Log() {}

  /** Logs a message of the usual category. */
  public static void info(String message) {
    info(CATEGORY, message);
  }

  public static void info(String category, String message) {
    System.getLogger(category).log(Level.INFO, () -> message);
  }

  /** Logs a message together with the place in the program that it is about. */
  public static void info(String category, String message, String function, String file, int line) {
    info(category, located(message, function, file, line));
  }

  /** Logs an error under the usual category. */
  public static void error(String message) {
    error(CATEGORY, message);
  }

  public static void error(String category, String message) {
    System.getLogger(category).log(Level.ERROR, () -> message);
  }

  /** Logs an error under the usual category, with the stack of what was thrown. */
  public static void error(String message, Throwable failure) {
    System.getLogger(CATEGORY).log(Level.ERROR, message, failure);
  }

  /** Logs an error together with the place in the program that it is about. */
  public static void error(
      String category, String message, String function, String file, int line) {
    error(category, located(message, function, file, line));
  }

  private static String located(String message, String function, String file, int line) {
    return message + " (" + function + ", " + file + ":" + line + ")";
  }
}

package org.urbi.server;

import java.io.PrintStream;
import java.util.Locale;

/**
 * The messages that the server has for its administrator, on the standard error stream: option
 * {@code --debug} and environment variable {@code GD_LEVEL} (manual, section 21.1.2).
 */
public final class Trace {
  /** How much is said, in increasing verbosity. */
  public enum Level {
    NONE("off"),
    LOG("info"),
    TRACE("info"),
    DEBUG("debug"),
    DUMP("trace");

    private final String inLibraries;

    Level(String inLibraries) {
      this.inLibraries = inLibraries;
    }

    /** The name of the level in the log of the libraries: that of slf4j-simple. */
    public String inLibraries() {
      return inLibraries;
    }

    /**
     * Reads a name or the number of its place.
     *
     * @throws IllegalArgumentException if it is neither
     */
    public static Level parse(String text) {
      for (Level level : values()) {
        if (level.name().equals(text.toUpperCase(Locale.ROOT))
            || text.equals(String.valueOf(level.ordinal()))) {
          return level;
        }
      }
      throw new IllegalArgumentException(
          "not a debug level: " + text + " (levels are NONE, LOG, TRACE, DEBUG and DUMP)");
    }
  }

  private final Level level;
  private final PrintStream out;

  public Trace(Level level, PrintStream out) {
    this.level = level;
    this.out = out;
  }

  /** How much is said. */
  public Level level() {
    return level;
  }

  /** Says what every administrator wants to know. */
  public void log(String message) {
    say(Level.LOG, message);
  }

  /** Says what helps to understand an unexpected behaviour. */
  public void debug(String message) {
    say(Level.DEBUG, message);
  }

  private void say(Level least, String message) {
    if (level.compareTo(least) >= 0) {
      out.println("urbi: " + message);
    }
  }
}

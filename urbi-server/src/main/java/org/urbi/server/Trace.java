package org.urbi.server;

import java.io.PrintStream;
import java.util.Locale;
import org.urbi.kernel.time.Clock;
import org.urbi.kernel.time.RateLimit;
import org.urbi.kernel.time.SystemClock;

/**
 * Writes messages for the administrator to the standard error stream: option {@code --debug} and
 * environment variable {@code GD_LEVEL} (manual, section 21.1.2).
 */
public final class Trace {
  /** The levels of verbosity, from the lowest to the highest. */
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

    /** The name of the corresponding level of slf4j-simple, which libraries log to. */
    public String inLibraries() {
      return inLibraries;
    }

    /**
     * Parses the name or the number of a level.
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

  /** How many clients that are turned away are told of in a second. */
  private static final int TURNED_AWAY = 10;

  private final Level level;
  private final PrintStream out;
  private final Clock clock;
  private final RateLimit turnedAway = new RateLimit(TURNED_AWAY);

  public Trace(Level level, PrintStream out) {
    this(level, out, new SystemClock());
  }

  /**
   * @param clock says how much a second is
   */
  Trace(Level level, PrintStream out, Clock clock) {
    this.level = level;
    this.out = out;
    this.clock = clock;
  }

  /** The current level. */
  public Level level() {
    return level;
  }

  /** Logs a message for every administrator. */
  public void log(String message) {
    say(Level.LOG, message);
  }

  /**
   * Logs, as {@link #log} does, that a client was turned away. It may come again and again, and
   * must not fill the log so: of more than some in a second is told only that there are more.
   */
  public synchronized void turnedAway(String message) {
    if (turnedAway.take(clock.now(), 1)) {
      log(message);
    } else if (turnedAway.beginsToRefuse()) {
      log("more clients are turned away, of which nothing is told for a moment");
    }
  }

  /** Logs a message that helps to debug unexpected behaviour. */
  public void debug(String message) {
    say(Level.DEBUG, message);
  }

  private void say(Level least, String message) {
    if (level.compareTo(least) >= 0) {
      out.println("urbi: " + message);
    }
  }
}

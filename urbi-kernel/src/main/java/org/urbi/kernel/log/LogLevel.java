package org.urbi.kernel.log;

import java.util.Locale;

/** How important a message of the log is, or how much of the log is shown (manual, "Logger"). */
public enum LogLevel {
  NONE,
  LOG,
  TRACE,
  DEBUG,
  DUMP;

  /** As urbiscript calls it. */
  public String label() {
    return name().charAt(0) + name().substring(1).toLowerCase(Locale.ROOT);
  }

  /** The level of that name or number; {@link #LOG} when there is none. */
  public static LogLevel of(String text) {
    for (LogLevel level : values()) {
      if (level.name().equalsIgnoreCase(text) || String.valueOf(level.ordinal()).equals(text)) {
        return level;
      }
    }
    return LOG;
  }
}

package org.urbi.ros.graph;

/** How grave what people are told on {@code /rosout} is. */
public enum Severity {
  DEBUG,
  INFO,
  WARN,
  ERROR,
  FATAL;

  /**
   * The one of that name, in small letters or capitals.
   *
   * @throws RosException if there is none
   */
  public static Severity of(String name) {
    for (Severity each : values()) {
      if (each.name().equalsIgnoreCase(name)) {
        return each;
      }
    }
    throw new RosException("level: debug, info, warn, error or fatal expected, not '" + name + "'");
  }
}

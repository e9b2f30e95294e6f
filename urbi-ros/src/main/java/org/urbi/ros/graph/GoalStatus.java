package org.urbi.ros.graph;

import java.util.Locale;

/** What becomes of the goal of an action, with the numbers that ROS 2 has for it. */
public enum GoalStatus {
  UNKNOWN,
  ACCEPTED,
  EXECUTING,
  CANCELING,
  SUCCEEDED,
  CANCELED,
  ABORTED;

  /** The one with that number; {@link #UNKNOWN} if there is none. */
  public static GoalStatus of(int number) {
    return number > 0 && number < values().length ? values()[number] : UNKNOWN;
  }

  /** Its number. */
  public int number() {
    return ordinal();
  }

  /** Whether nothing more becomes of the goal. */
  public boolean isEnd() {
    return compareTo(SUCCEEDED) >= 0;
  }

  /** Its name in small letters, for people. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}

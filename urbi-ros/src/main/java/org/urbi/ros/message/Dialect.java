package org.urbi.ros.message;

/**
 * Which ROS a definition is written for: both have files of the same look that mean other types.
 */
public enum Dialect {
  /** ROS 1: {@code time} and {@code duration} are basic types, {@code Header} needs no package. */
  ROS_1,
  /** ROS 2: bounds, defaults and wide strings. */
  ROS_2;

  /** 1 or 2. */
  public int version() {
    return ordinal() + 1;
  }
}

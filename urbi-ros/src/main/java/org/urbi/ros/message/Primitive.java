package org.urbi.ros.message;

/** The basic types of fields, but for texts. */
public enum Primitive {
  BOOL(1),
  /** A byte: signed in ROS 1, unsigned in ROS 2. */
  BYTE(1),
  /** A number of 8 bits without a sign. */
  CHAR(1),
  INT8(1),
  UINT8(1),
  INT16(2),
  UINT16(2),
  INT32(4),
  UINT32(4),
  INT64(8),
  UINT64(8),
  FLOAT32(4),
  FLOAT64(8),
  /** Of ROS 1: two numbers without a sign, seconds and nanoseconds. */
  TIME(8),
  /** Of ROS 1: two numbers with a sign, seconds and nanoseconds. */
  DURATION(8);

  private final int size;

  Primitive(int size) {
    this.size = size;
  }

  /** How many bytes a value has. */
  public int size() {
    return size;
  }

  /** Whether it has two parts, seconds and nanoseconds. */
  public boolean isInstant() {
    return this == TIME || this == DURATION;
  }
}

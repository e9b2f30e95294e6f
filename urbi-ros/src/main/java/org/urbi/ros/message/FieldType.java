package org.urbi.ros.message;

/** The type of a field. */
public sealed interface FieldType {
  /** A number, a Boolean, or a time of ROS 1. */
  record Basic(Primitive primitive) implements FieldType {}

  /**
   * A string.
   *
   * @param wide whether its characters have 16 bits on the wire
   * @param limit how many bytes of UTF-8 it may have, or units of 16 bits when it is wide; 0 for
   *     any number
   */
  record Text(boolean wide, int limit) implements FieldType {}

  /** Another message. */
  record Nested(TypeName name) implements FieldType {}

  /**
   * Any number of the same.
   *
   * @param element no array
   * @param size how many, or how many at most; 0 without a limit
   */
  record Array(FieldType element, Length length, int size) implements FieldType {}

  /** How many elements an array has. */
  enum Length {
    FIXED,
    BOUNDED,
    ANY
  }
}

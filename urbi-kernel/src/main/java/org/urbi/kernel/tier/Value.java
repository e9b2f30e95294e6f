package org.urbi.kernel.tier;

/**
 * Where emitted code keeps a value: a double, an object, or both, of which the object counts unless
 * it is null.
 *
 * @param number the slot of the double; -1 if there is none
 * @param object the slot of the object; -1 if it is a plain number of which there is no object
 * @param variable the index of the urbiscript variable whose slots these are; -1 for a value that
 *     nothing changes
 */
record Value(int number, int object, int variable) {
  private static final int NONE = -1;

  static Value ofNumber(int slot) {
    return new Value(slot, NONE, NONE);
  }

  static Value ofObject(int slot) {
    return new Value(NONE, slot, NONE);
  }

  static Value ofPair(int number, int object) {
    return new Value(number, object, NONE);
  }

  boolean hasNumber() {
    return number >= 0;
  }

  boolean hasObject() {
    return object >= 0;
  }

  boolean isVariable() {
    return variable >= 0;
  }
}

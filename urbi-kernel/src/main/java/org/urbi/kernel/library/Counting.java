package org.urbi.kernel.library;

import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;

/** Numbers that count something, and indexes. */
final class Counting {
  private Counting() {}

  /** An integer of 64 bits; the place is 0 for the target. */
  static long integer(Frame caller, CallSite site, int place, UrbiFloat given) {
    return Arguments.longInteger(caller, site, place, given);
  }

  /** A number of times. */
  static int nonNegative(Frame caller, CallSite site, int place, UrbiFloat given) {
    if (given.value() < 0) {
      throw Arguments.negativeInteger(caller, site, place, given);
    }
    return Arguments.integer(caller, site, place, given);
  }

  /** An index from 0 to the size, excluded; negative ones count from the end. */
  static int index(Frame caller, CallSite site, int index, int size) {
    int counted = index < 0 ? index + size : index;
    if (counted < 0 || counted >= size) {
      throw invalidIndex(caller, site, index);
    }
    return counted;
  }

  /** {@code routine: invalid index: 3}. */
  static RuntimeException invalidIndex(Frame caller, CallSite site, int index) {
    return caller.interpreter().errors().primitive(site.calledName(), "invalid index: " + index);
  }
}

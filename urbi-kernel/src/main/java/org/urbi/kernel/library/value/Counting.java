package org.urbi.kernel.library.value;

import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;

/** Numbers that count something, and indexes. */
public final class Counting {
  /** As many elements as one call can make: about half a gigabyte. */
  private static final int LONGEST_LIST = 1 << 24;

  /** As many characters as one call can make: a quarter of a gigabyte. */
  private static final int LONGEST_STRING = 1 << 28;

  /** The least that an element of a list takes. */
  private static final int BYTES_OF_ELEMENT = 4;

  private Counting() {}

  /** A number of 64 bits, without what is behind the point; the place is 0 for the target. */
  public static long integer(Frame caller, CallSite site, int place, UrbiFloat given) {
    return Arguments.longInteger(caller, site, place, given);
  }

  /** A number of times. */
  public static int nonNegative(Frame caller, CallSite site, int place, UrbiFloat given) {
    if (given.value() < 0 || given.value() != Math.rint(given.value())) {
      throw Arguments.negativeInteger(caller, site, place, given);
    }
    return Arguments.integer(caller, site, place, given);
  }

  /**
   * A number of times something is repeated, to make something of at most that size, which the
   * budget must allow: afterwards it would be too late.
   */
  private static int repetitions(
      Frame caller,
      CallSite site,
      int place,
      UrbiFloat given,
      int size,
      int most,
      int bytes,
      Problem excess) {
    int count = nonNegative(caller, site, place, given);
    long length = (long) count * size;
    if (length > most) {
      throw caller.error(site, excess);
    }
    checkMemory(caller, length * bytes);
    return count;
  }

  /**
   * The budget must allow to make something of that many bytes: afterwards it would be too late.
   */
  public static void checkMemory(Frame caller, long bytes) {
    if (!caller.job().budget().allows(Resource.MEMORY, bytes)) {
      throw caller.job().identity().refusal(Resource.MEMORY);
    }
  }

  /** The budget must allow to make a list of that many elements. */
  public static void checkMemoryOfList(Frame caller, long elements) {
    checkMemory(caller, elements * BYTES_OF_ELEMENT);
  }

  /** A number of times to repeat a list; what does not fit in any memory is an error. */
  public static int ofLists(Frame caller, CallSite site, int place, UrbiFloat given, int size) {
    return repetitions(
        caller, site, place, given, size, LONGEST_LIST, BYTES_OF_ELEMENT, Problem.LIST_TOO_LONG);
  }

  /** A number of times to repeat a string; what does not fit in any memory is an error. */
  public static int ofStrings(Frame caller, CallSite site, int place, UrbiFloat given, int size) {
    return repetitions(
        caller, site, place, given, size, LONGEST_STRING, 1, Problem.STRING_TOO_LONG);
  }

  /** An index from 0 to the size, excluded; negative ones count from the end. */
  public static int index(Frame caller, CallSite site, int index, int size) {
    int counted = index < 0 ? index + size : index;
    if (counted < 0 || counted >= size) {
      throw invalidIndex(caller, site, index);
    }
    return counted;
  }

  /** An index from 0 to the size, excluded, given as a number, which must be whole. */
  public static int index(Frame caller, CallSite site, UrbiFloat index, int size) {
    return index(caller, site, index(caller, site, index), size);
  }

  /** A number as an index: one with a fraction is none. */
  public static int index(Frame caller, CallSite site, UrbiFloat index) {
    double value = index.value();
    if (value != (int) value) {
      throw caller.error(site, Problem.INDEX, caller.interpreter().asString(caller, index));
    }
    return (int) value;
  }

  /** {@code routine: invalid index: 3}. */
  public static RuntimeException invalidIndex(Frame caller, CallSite site, int index) {
    return caller.error(site, Problem.INDEX, index);
  }
}

package org.urbi.kernel.builtin;

import java.util.Arrays;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.World;

/**
 * Converts the arguments of a call in urbiscript to those of a Java method, or throws the errors of
 * the manual ("Exception.Argument", "Exception.Type", "Exception.BadInteger"). Called by the
 * generated tables; index 0 is the target.
 */
public final class Arguments {
  private static final UrbiObject[] NONE = {};

  private Arguments() {}

  /**
   * Refuses an argument of the wrong type.
   *
   * @return never
   */
  public static <T> T unexpected(
      Frame caller, CallSite site, int place, UrbiObject given, String expected) {
    throw type(caller, site, place, given, expected);
  }

  /** {@code routine: argument 1: unexpected "x", expected a Float}. */
  public static UrbiException type(
      Frame caller, CallSite site, int place, UrbiObject given, String expected) {
    Errors errors = caller.interpreter().errors();
    World world = caller.interpreter().world();
    if (given == world.values().voidObject) {
      return errors.unexpectedVoid();
    }
    UrbiObject prototype = world.findPrototype(expected);
    return errors.argumentType(
        site.calledName(), place, given, prototype == null ? world.values().nil : prototype);
  }

  /** A number. */
  public static double number(Frame caller, CallSite site, int place, UrbiObject given) {
    return given instanceof UrbiFloat number
        ? number.value()
        : Arguments.<UrbiFloat>unexpected(caller, site, place, given, "Float").value();
  }

  /** A number of 32 bits; what it has behind the point is dropped. */
  public static int integer(Frame caller, CallSite site, int place, UrbiObject given) {
    double value = number(caller, site, place, given);
    int integer = (int) value;
    checkIsNear(caller, site, place, given, integer - value);
    return integer;
  }

  /** A number of 64 bits; what it has behind the point is dropped. */
  public static long longInteger(Frame caller, CallSite site, int place, UrbiObject given) {
    double value = number(caller, site, place, given);
    long integer = (long) value;
    checkIsNear(caller, site, place, given, integer - value);
    return integer;
  }

  /** Refuses values that are not numbers, and numbers that do not fit. */
  private static void checkIsNear(
      Frame caller, CallSite site, int place, UrbiObject given, double dropped) {
    if (!(Math.abs(dropped) < 1)) {
      throw notInteger(caller, site, place, given);
    }
  }

  /** {@code routine: argument 1: expected integer, got 0.5}. */
  public static UrbiException notInteger(Frame caller, CallSite site, int place, UrbiObject given) {
    return caller
        .interpreter()
        .errors()
        .argumentNumber(site.calledName(), place, Problem.NOT_INTEGER, given);
  }

  /** {@code routine: argument 1: expected non-negative integer, got -2}. */
  public static UrbiException negativeInteger(
      Frame caller, CallSite site, int place, UrbiObject given) {
    return caller
        .interpreter()
        .errors()
        .argumentNumber(site.calledName(), place, Problem.NOT_NON_NEGATIVE_INTEGER, given);
  }

  /** The text of a String. */
  public static String text(Frame caller, CallSite site, int place, UrbiObject given) {
    return given instanceof UrbiString string
        ? string.value()
        : Arguments.<UrbiString>unexpected(caller, site, place, given, "String").value();
  }

  /** Whether the value counts as true (manual, "Truth Values"). */
  public static boolean truth(Frame caller, CallSite site, int place, UrbiObject given) {
    return Truth.of(caller, given);
  }

  /** The arguments from an index on, as a new array. */
  public static UrbiObject[] rest(UrbiObject[] arguments, int from) {
    return arguments.length <= from ? NONE : Arrays.copyOfRange(arguments, from, arguments.length);
  }
}

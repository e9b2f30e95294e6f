package org.urbi.kernel.library.math;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.object.UrbiObject;

/** The limits of numbers (manual, "Float.limits"). */
@UrbiType(
    value = "Float.limits",
    protos = "Singleton",
    doc = "The limits of what Floats can represent.",
    needs = Permission.NOTHING)
final class FloatLimits {
  private FloatLimits() {}

  @Builtin(doc = "The number of digits of the mantissa, in base radix.")
  static int digits(UrbiObject self) {
    return Double.PRECISION;
  }

  @Builtin(doc = "The number of decimal digits that are never lost.")
  static int digits10(UrbiObject self) {
    return 15;
  }

  @Builtin(doc = "The difference between 1 and the next number.")
  static double epsilon(UrbiObject self) {
    return Math.ulp(1.0);
  }

  @Builtin(doc = "The greatest finite number.")
  static double max(UrbiObject self) {
    return Double.MAX_VALUE;
  }

  @Builtin(doc = "The power of radix from which on numbers are infinite.")
  static int maxExponent(UrbiObject self) {
    return Double.MAX_EXPONENT + 1;
  }

  @Builtin(doc = "The greatest finite power of 10.")
  static int maxExponent10(UrbiObject self) {
    return 308;
  }

  @Builtin(doc = "The least positive number of full precision.")
  static double min(UrbiObject self) {
    return Double.MIN_NORMAL;
  }

  @Builtin(doc = "The least power of radix, plus one, of full precision.")
  static int minExponent(UrbiObject self) {
    return Double.MIN_EXPONENT + 1;
  }

  @Builtin(doc = "The least power of 10 of full precision.")
  static int minExponent10(UrbiObject self) {
    return -307;
  }

  @Builtin(doc = "The base of the exponent.")
  static int radix(UrbiObject self) {
    return 2;
  }
}

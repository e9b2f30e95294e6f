package org.urbi.kernel.library.math;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.value.Printing;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;

/** The mathematical functions of numbers (manual, "Float"). */
@UrbiTypePart(value = "Float", needs = Permission.NOTHING)
final class FloatFunctions {
  private FloatFunctions() {}

  @Builtin(doc = "The absolute value.")
  static double abs(UrbiFloat self) {
    return Math.abs(self.value());
  }

  @Builtin(doc = "The arccosine, in radians.")
  static double acos(Frame caller, CallSite site, UrbiFloat self) {
    checkSine(caller, site, self);
    return Math.acos(self.value());
  }

  @Builtin(doc = "The arcsine, in radians.")
  static double asin(Frame caller, CallSite site, UrbiFloat self) {
    checkSine(caller, site, self);
    return Math.asin(self.value());
  }

  private static void checkSine(Frame caller, CallSite site, UrbiFloat self) {
    if (self.value() < -1 || self.value() > 1) {
      throw caller.error(site, Problem.RANGE);
    }
  }

  @Builtin(doc = "The arctangent, in radians.")
  static double atan(UrbiFloat self) {
    return Math.atan(self.value());
  }

  @Builtin(doc = "The angle, in radians, whose tangent is the target divided by that.")
  static double atan2(UrbiFloat self, double that) {
    return Math.atan2(self.value(), that);
  }

  @Builtin(doc = "The cosine.")
  static double cos(UrbiFloat self) {
    return Math.cos(self.value());
  }

  @Builtin(doc = "The sine.")
  static double sin(UrbiFloat self) {
    return Math.sin(self.value());
  }

  @Builtin(doc = "The tangent.")
  static double tan(UrbiFloat self) {
    return Math.tan(self.value());
  }

  @Builtin(doc = "The exponential.")
  static double exp(UrbiFloat self) {
    return Math.exp(self.value());
  }

  @Builtin(doc = "The natural logarithm.")
  static double log(Frame caller, CallSite site, UrbiFloat self) {
    checkPositive(caller, site, self);
    return Math.log(self.value());
  }

  @Builtin(doc = "The square root.")
  static double sqrt(Frame caller, CallSite site, UrbiFloat self) {
    checkPositive(caller, site, self);
    return Math.sqrt(self.value());
  }

  private static void checkPositive(Frame caller, CallSite site, UrbiFloat self) {
    if (self.value() < 0) {
      throw caller.error(site, Problem.HAS_TO_BE_POSITIVE);
    }
  }

  @Builtin(doc = "The square.")
  static double sqr(UrbiFloat self) {
    return self.value() * self.value();
  }

  @Builtin(doc = "The least integer that is not less.")
  static double ceil(UrbiFloat self) {
    return Math.ceil(self.value());
  }

  @Builtin(doc = "The greatest integer that is not greater.")
  static double floor(UrbiFloat self) {
    return Math.floor(self.value());
  }

  @Builtin(doc = "The nearest integer; of two, the one farther from 0.")
  static double round(UrbiFloat self) {
    double size = Math.abs(self.value());
    double whole = Math.floor(size);
    return Math.copySign(size - whole >= 0.5 ? whole + 1 : whole, self.value());
  }

  @Builtin(doc = "The integer before the decimal point.")
  static double trunc(UrbiFloat self) {
    return self.value() < 0 ? Math.ceil(self.value()) : Math.floor(self.value());
  }

  @Builtin(doc = "1 if it is positive, 0 if it is 0, -1 otherwise.")
  static double sign(UrbiFloat self) {
    return self.value() > 0 ? 1 : self.value() == 0 ? 0 : -1;
  }

  @Builtin(doc = "A random integer from 0 to the target, which it is less than.")
  static double random(Frame caller, CallSite site, UrbiFloat self) {
    if (self.value() < 0) {
      throw caller
          .interpreter()
          .errors()
          .badNumber(site.calledName(), Problem.NEGATIVE, self, Printing.printable(caller, self));
    }
    return caller.interpreter().world().randomNumbers().below(self.value());
  }

  @Builtin(
      doc = "Makes the target the seed of the random numbers that follow.",
      needs = Permission.OWNER)
  static void srandom(Frame caller, UrbiFloat self) {
    caller.interpreter().world().randomNumbers().seed((long) self.value());
  }
}

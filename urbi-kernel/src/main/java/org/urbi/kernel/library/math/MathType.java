package org.urbi.kernel.library.math;

import java.util.Arrays;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.collection.ListOrder;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;

/** The functions of numbers as functions of one argument (manual, "Math"). */
@UrbiType(
    value = "Math",
    protos = "Singleton",
    doc = "The mathematical functions, with their usual notation.",
    needs = Permission.NOTHING)
final class MathType {
  private MathType() {}

  /** Sends a message to the argument. */
  private static UrbiObject bounce(
      Frame caller,
      CallSite site,
      UrbiObject self,
      UrbiObject x,
      String name,
      UrbiObject... arguments) {
    Interpreter interpreter = caller.interpreter();
    Symbol message = interpreter.world().symbol(name);
    // These functions are known to every object: one without its own would call this one again.
    if (x.lookup(message) == self.lookup(message)) {
      throw interpreter.errors().argumentType(name, 1, x, interpreter.values().floatProto);
    }
    return interpreter.send(caller, site, x, message, arguments);
  }

  @Builtin(doc = "The absolute value of x.")
  static UrbiObject abs(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "abs");
  }

  @Builtin(doc = "The arccosine of x, in radians.")
  static UrbiObject acos(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "acos");
  }

  @Builtin(doc = "The arcsine of x, in radians.")
  static UrbiObject asin(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "asin");
  }

  @Builtin(doc = "The arctangent of x, in radians.")
  static UrbiObject atan(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "atan");
  }

  @Builtin(doc = "The cosine of x.")
  static UrbiObject cos(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "cos");
  }

  @Builtin(doc = "The exponential of x.")
  static UrbiObject exp(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "exp");
  }

  @Builtin(doc = "The natural logarithm of x.")
  static UrbiObject log(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "log");
  }

  @Builtin(doc = "A random integer from 0 to x, which it is less than.")
  static UrbiObject random(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "random");
  }

  @Builtin(doc = "The integer nearest to x.")
  static UrbiObject round(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "round");
  }

  @Builtin(doc = "1 if x is positive, 0 if it is 0, -1 otherwise.")
  static UrbiObject sign(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "sign");
  }

  @Builtin(doc = "The sine of x.")
  static UrbiObject sin(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "sin");
  }

  @Builtin(doc = "The square of x.")
  static UrbiObject sqr(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "sqr");
  }

  @Builtin(doc = "The square root of x.")
  static UrbiObject sqrt(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "sqrt");
  }

  @Builtin(doc = "Makes x the seed of the random numbers that follow.", needs = Permission.OWNER)
  static UrbiObject srandom(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "srandom");
  }

  @Builtin(doc = "The tangent of x.")
  static UrbiObject tan(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "tan");
  }

  @Builtin(doc = "The integer before the decimal point of x.")
  static UrbiObject trunc(Frame caller, CallSite site, UrbiObject self, UrbiObject x) {
    return bounce(caller, site, self, x, "trunc");
  }

  @Builtin(doc = "The angle, in radians, whose tangent is x / y.")
  static UrbiObject atan2(
      Frame caller, CallSite site, UrbiObject self, UrbiObject x, UrbiObject y) {
    return bounce(caller, site, self, x, "atan2", y);
  }

  @Builtin(doc = "The greatest of the arguments.")
  static UrbiObject max(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
    return ListOrder.max(caller, site, Arrays.asList(arguments), self, null);
  }

  @Builtin(doc = "The least of the arguments.")
  static UrbiObject min(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
    return ListOrder.min(caller, site, Arrays.asList(arguments), self, null);
  }

  @Builtin(doc = "Infinity.")
  static double inf(UrbiObject self) {
    return Double.POSITIVE_INFINITY;
  }

  @Builtin(doc = "What is not a number, and equal to nothing, not even itself.")
  static double nan(UrbiObject self) {
    return Double.NaN;
  }

  @Builtin(doc = "The ratio of the circumference of a circle to its diameter.")
  static double pi(UrbiObject self) {
    return Math.PI;
  }
}

package org.urbi.kernel.library.math;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.collection.ListOrder;
import org.urbi.kernel.library.text.Formatting;
import org.urbi.kernel.library.text.UrbiFormatInfo;
import org.urbi.kernel.library.value.Counting;
import org.urbi.kernel.library.value.Hashing;
import org.urbi.kernel.library.value.Iteration;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.print.FloatFormat;

/** Numbers (manual, "Float"): their operators, conversions and comparisons. */
@UrbiType(
    value = "Float",
    protos = {"Comparable", "Orderable", "RangeIterable"},
    doc = "A floating point number, which integers are too.",
    needs = Permission.NOTHING)
public final class FloatType {
  /** How much "almost equal" numbers differ at most. */
  public static final double TOLERANCE = 1e-4;

  private FloatType() {}

  // ------------------------------------------------------------------ operators

  @Builtin(value = "+", doc = "The sum of the target and that; without that, the target.")
  static UrbiFloat plus(Frame caller, UrbiFloat self, @Optional @Nullable Double that) {
    return that == null ? self : number(caller, self.value() + that);
  }

  @Builtin(value = "-", doc = "The target minus that; without that, its opposite.")
  static UrbiFloat minus(Frame caller, UrbiFloat self, @Optional @Nullable Double that) {
    // The opposite of 0 is 0, and not -0.
    return number(caller, that == null ? 0 - self.value() : self.value() - that);
  }

  @Builtin(value = "*", doc = "The product of the target and that.")
  static double multiply(UrbiFloat self, double that) {
    return self.value() * that;
  }

  @Builtin(value = "/", doc = "The quotient of the target divided by that, which is not 0.")
  static double divide(Frame caller, CallSite site, UrbiFloat self, double that) {
    if (that == 0) {
      throw caller.error(site, Problem.DIVISION_BY_ZERO);
    }
    return self.value() / that;
  }

  @Builtin(value = "%", doc = "The target modulo that, with the sign of the target.")
  static double modulo(Frame caller, CallSite site, UrbiFloat self, double that) {
    if (that == 0) {
      throw caller.error(site, Problem.MODULO_BY_ZERO);
    }
    return self.value() % that;
  }

  @Builtin(value = "**", doc = "The target to the power of that.")
  static double power(UrbiFloat self, double that) {
    return Math.pow(self.value(), that);
  }

  @Builtin(value = "==", doc = "Whether that is a number equal to the target.")
  static boolean equals(UrbiFloat self, UrbiObject that) {
    return that instanceof UrbiFloat other && self.value() == other.value();
  }

  @Builtin(value = "!=", doc = "Whether that is not a number equal to the target.")
  static boolean differs(UrbiFloat self, UrbiObject that) {
    return !equals(self, that);
  }

  @Builtin(value = "~=", doc = "Whether they differ by little, relative to their size.")
  static boolean almostEquals(UrbiFloat self, double that) {
    double tolerance =
        self.lookup(self.world().symbol("epsilonTilde")) instanceof UrbiFloat set
            ? set.value()
            : TOLERANCE;
    // Near zero sizes mean nothing.
    double size = Math.max(1, Math.max(Math.abs(self.value()), Math.abs(that)));
    return self.value() == that || Math.abs(self.value() - that) <= tolerance * size;
  }

  @Builtin(value = "=~=", doc = "Whether they differ by little.")
  static boolean isNear(UrbiFloat self, double that) {
    return self.value() == that || Math.abs(self.value() - that) <= TOLERANCE;
  }

  @Builtin(value = "<", doc = "Whether the target is less than that.")
  static boolean less(UrbiFloat self, double that) {
    return self.value() < that;
  }

  @Builtin(value = "<=", doc = "Whether the target is less than, or equal to, that.")
  static boolean lessOrEqual(UrbiFloat self, double that) {
    return self.value() <= that;
  }

  @Builtin(value = ">", doc = "Whether the target is greater than that.")
  static boolean greater(UrbiFloat self, double that) {
    return self.value() > that;
  }

  @Builtin(value = ">=", doc = "Whether the target is greater than, or equal to, that.")
  static boolean greaterOrEqual(UrbiFloat self, double that) {
    return self.value() >= that;
  }

  // ------------------------------------------------------------------ bits

  @Builtin(value = "bitand", doc = "The bitwise and of two integers.")
  static double bitAnd(Frame caller, CallSite site, UrbiFloat self, long that) {
    return integer(caller, site, self) & that;
  }

  @Builtin(value = "bitor", doc = "The bitwise or of two integers.")
  static double bitOr(Frame caller, CallSite site, UrbiFloat self, long that) {
    return integer(caller, site, self) | that;
  }

  @Builtin(value = "^", doc = "The bitwise exclusive or of two integers.")
  static double bitXor(Frame caller, CallSite site, UrbiFloat self, long that) {
    return integer(caller, site, self) ^ that;
  }

  @Builtin(doc = "The bitwise complement of an integer of 32 bits.")
  static double compl(Frame caller, CallSite site, UrbiFloat self) {
    return ~integer(caller, site, self) & 0xFFFF_FFFFL;
  }

  @Builtin(value = "<<", doc = "An integer shifted by that number of bits to the left.")
  static double shiftLeft(Frame caller, CallSite site, UrbiFloat self, UrbiFloat that) {
    return integer(caller, site, self) << bits(caller, site, that);
  }

  @Builtin(value = ">>", doc = "An integer shifted by that number of bits to the right.")
  static double shiftRight(Frame caller, CallSite site, UrbiFloat self, UrbiFloat that) {
    return integer(caller, site, self) >> bits(caller, site, that);
  }

  private static int bits(Frame caller, CallSite site, UrbiFloat that) {
    long bits = Counting.integer(caller, site, 1, that);
    if (bits < 0) {
      throw Arguments.negativeInteger(caller, site, 1, that);
    }
    return (int) Math.min(63, bits);
  }

  // ------------------------------------------------------------------ conversions

  @Builtin(doc = "Whether the target is not 0.")
  static boolean asBool(UrbiFloat self) {
    return self.value() != 0;
  }

  @Builtin(doc = "The target.")
  static UrbiFloat asFloat(UrbiFloat self) {
    return self;
  }

  @Builtin(
      value = {"asString"},
      doc = "The number in decimal.")
  static String asString(UrbiFloat self) {
    return FloatFormat.format(self.value());
  }

  @Builtin(doc = "The number in decimal, unless asString is another one.")
  static UrbiObject asPrintable(Frame frame, UrbiFloat self) {
    return self.shape() == self.world().values().floatShape
        ? self.world().values().string(asString(self))
        : frame.interpreter().send(frame, self, "asString");
  }

  @Builtin(
      value = {"seq", "asList"},
      doc = "The list of the integers from 0 to the target, which is not in it.")
  static List<UrbiObject> seq(Frame caller, CallSite site, UrbiFloat self) {
    int count = Counting.ofLists(caller, site, 0, self, 1);
    List<UrbiObject> numbers = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      caller.job().worked(1);
      numbers.add(number(caller, i));
    }
    return numbers;
  }

  @Builtin(doc = "An integer in hexadecimal.")
  static String hex(Frame caller, UrbiFloat self) {
    return Formatting.hexadecimal(caller, "format", self);
  }

  @Builtin(doc = "The number as a FormatInfo says.")
  static String format(Frame caller, CallSite site, UrbiFloat self, UrbiFormatInfo finfo) {
    return Formatting.format(caller, site.calledName(), self, finfo);
  }

  @Builtin(doc = "A Hash, equal for equal numbers.")
  static UrbiHash hash(Frame caller, UrbiFloat self) {
    return Hashing.hash(caller, Hashing.code(self.value()));
  }

  // ------------------------------------------------------------------ comparisons

  @Builtin(doc = "The greatest of the target and the arguments.")
  static UrbiObject max(Frame caller, CallSite site, UrbiFloat self, UrbiObject... others) {
    return ListOrder.max(caller, site, withSelf(self, others), self, null);
  }

  @Builtin(doc = "The least of the target and the arguments.")
  static UrbiObject min(Frame caller, CallSite site, UrbiFloat self, UrbiObject... others) {
    return ListOrder.min(caller, site, withSelf(self, others), self, null);
  }

  private static List<UrbiObject> withSelf(UrbiFloat self, UrbiObject[] others) {
    List<UrbiObject> all = new ArrayList<>(others.length + 1);
    all.addAll(Arrays.asList(others));
    all.add(self);
    return all;
  }

  @Builtin(doc = "Whether it is not a number.")
  static boolean isNan(UrbiFloat self) {
    return Double.isNaN(self.value());
  }

  @Builtin(doc = "Whether it is infinite.")
  static boolean isInf(UrbiFloat self) {
    return Double.isInfinite(self.value());
  }

  // ------------------------------------------------------------------ constants and sequences

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

  @Builtin(doc = "A new integer at each call.")
  static double fresh(Frame caller, UrbiObject self) {
    return caller.interpreter().world().count("Float.fresh", 1);
  }

  // ------------------------------------------------------------------ loops

  @Builtin(doc = "Calls fun that many times.")
  static void times(Frame caller, CallSite site, UrbiFloat self, UrbiObject fun) {
    for (long i = 0; i < self.value(); i++) {
      caller.interpreter().call(caller, site, fun, self);
      caller.job().yield();
    }
  }

  @Builtin(doc = "Calls fun with each integer from 0 to the target, one after the other.")
  static void each(Frame caller, CallSite site, UrbiFloat self, UrbiObject fun) {
    for (long i = 0; i < self.value(); i++) {
      caller.interpreter().call(caller, site, fun, self, number(caller, i));
      caller.job().yield();
    }
  }

  @Builtin(value = "each|", doc = "Calls fun with each integer, without letting others run.")
  static void eachTight(Frame caller, CallSite site, UrbiFloat self, UrbiObject fun) {
    for (long i = 0; i < self.value(); i++) {
      caller.job().checkInterrupted();
      caller.interpreter().call(caller, site, fun, self, number(caller, i));
    }
  }

  @Builtin(value = "each&", doc = "Calls fun with each integer from 0 to the target, all at once.")
  static void eachConcurrent(Frame caller, CallSite site, UrbiFloat self, UrbiObject fun) {
    UrbiFloat turns = number(caller, Math.max(0, Math.ceil(self.value())));
    Iteration.concurrently(caller, site, self, seq(caller, site, turns), fun);
  }

  // ------------------------------------------------------------------ helpers

  static UrbiFloat number(Frame caller, double value) {
    return caller.interpreter().world().values().number(value);
  }

  /** The target as an integer, for operations on bits. */
  private static long integer(Frame caller, CallSite site, UrbiFloat self) {
    return Counting.integer(caller, site, 0, self);
  }
}

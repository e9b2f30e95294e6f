package org.urbi.kernel.library.math;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.library.value.Counting;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.object.World;

/** Vectors of numbers. */
@UrbiType(
    value = "Vector",
    doc = "A vector of numbers, with arithmetic element by element.",
    needs = Permission.NOTHING)
final class VectorType {
  private VectorType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiVector(world.values().object.cloneShape(), new double[0]);
  }

  @Builtin(doc = "Of these numbers, or of those in a list.", needs = Permission.CHANGE)
  static void init(Frame frame, CallSite site, UrbiVector self, UrbiObject... elements) {
    List<UrbiObject> values =
        elements.length == 1 && elements[0] instanceof UrbiList list
            ? list.elements()
            : Arrays.asList(elements);
    self.setElements(Elementwise.numbers(frame, site, 1, values));
  }

  @Builtin(doc = "The number of elements.")
  static double size(UrbiVector self) {
    return self.elements().length;
  }

  @Builtin(value = "[]", doc = "The element at an index.")
  static double at(Frame frame, CallSite site, UrbiVector self, int index) {
    return self.elements()[Counting.index(frame, site, index, self.elements().length)];
  }

  @Builtin(
      value = "[]=",
      doc = "Replaces the element at an index; returns the value.",
      needs = Permission.CHANGE)
  static double setAt(Frame frame, CallSite site, UrbiVector self, int index, double value) {
    double[] changed = Elementwise.copy(frame, self.elements());
    changed[Counting.index(frame, site, index, changed.length)] = value;
    self.setElements(changed);
    return value;
  }

  private static UrbiObject combined(
      Frame frame,
      CallSite site,
      UrbiVector self,
      UrbiObject that,
      DoubleBinaryOperator operation) {
    return switch (that) {
      case UrbiFloat number ->
          self.sibling(Elementwise.each(frame, self.elements(), number.value(), operation));
      case UrbiVector other -> {
        Elementwise.requireSame(frame, site, other.elements().length == self.elements().length);
        yield self.sibling(Elementwise.pairs(frame, self.elements(), other.elements(), operation));
      }
      default -> throw Arguments.type(frame, site, 1, that, "Vector");
    };
  }

  @Builtin(value = "+", doc = "The sum with a vector, or with a number for each element.")
  static UrbiObject plus(Frame frame, CallSite site, UrbiVector self, UrbiObject that) {
    return combined(frame, site, self, that, (x, y) -> x + y);
  }

  @Builtin(value = "-", doc = "The difference to a vector, or to a number for each element.")
  static UrbiObject minus(Frame frame, CallSite site, UrbiVector self, UrbiObject that) {
    return combined(frame, site, self, that, (x, y) -> x - y);
  }

  @Builtin(value = "*", doc = "The product with a vector, element by element, or with a number.")
  static UrbiObject times(Frame frame, CallSite site, UrbiVector self, UrbiObject that) {
    return combined(frame, site, self, that, (x, y) -> x * y);
  }

  @Builtin(value = "/", doc = "The quotient by a vector, element by element, or by a number.")
  static UrbiObject divided(Frame frame, CallSite site, UrbiVector self, UrbiObject that) {
    return combined(frame, site, self, that, (x, y) -> x / y);
  }

  @Builtin(doc = "The sum of the elements.")
  static double sum(UrbiVector self) {
    return Arrays.stream(self.elements()).sum();
  }

  @Builtin(doc = "The Euclidean length.")
  static double norm(UrbiVector self) {
    return Math.sqrt(Arrays.stream(self.elements()).map(x -> x * x).sum());
  }

  @Builtin(value = "==", doc = "Whether both have the same elements.")
  static boolean equal(UrbiVector self, UrbiObject that) {
    return that instanceof UrbiVector other && Arrays.equals(self.elements(), other.elements());
  }

  @Builtin(value = "!=", doc = "Whether they have not the same elements.")
  static boolean differs(UrbiVector self, UrbiObject that) {
    return !equal(self, that);
  }

  @Builtin(doc = "The list of the elements.")
  static List<UrbiObject> asList(Frame frame, UrbiVector self) {
    Values values = self.world().values();
    List<UrbiObject> numbers = new ArrayList<>(self.elements().length);
    for (double element : self.elements()) {
      frame.job().worked(1);
      numbers.add(values.number(element));
    }
    return numbers;
  }

  @Builtin(doc = "The elements between angle brackets.")
  static String asString(Frame frame, UrbiVector self) {
    double[] elements = self.elements();
    return "<" + Elementwise.text(frame, elements, 0, elements.length) + ">";
  }
}

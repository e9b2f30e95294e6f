package org.urbi.kernel.library.math;

import java.util.List;
import java.util.function.DoubleBinaryOperator;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.value.Counting;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.print.FloatFormat;

/** The common part of vectors and matrices: arithmetic element by element. */
final class Elementwise {
  /** What it costs to write a number. */
  private static final int STEPS_FOR_NUMBER = 16;

  private Elementwise() {}

  /** So many zeros, which the budget must allow. */
  static double[] zeros(Frame frame, int count) {
    Counting.checkMemory(frame, (long) count * Double.BYTES);
    return new double[count];
  }

  /** The same numbers in another array, which the budget must allow. */
  static double[] copy(Frame frame, double[] numbers) {
    double[] copy = zeros(frame, numbers.length);
    System.arraycopy(numbers, 0, copy, 0, numbers.length);
    return copy;
  }

  /** Each element with that number. */
  static double[] each(Frame frame, double[] left, double right, DoubleBinaryOperator operation) {
    double[] values = zeros(frame, left.length);
    for (int i = 0; i < values.length; i++) {
      frame.job().worked(1);
      values[i] = operation.applyAsDouble(left[i], right);
    }
    return values;
  }

  /** Each element with the one at the same place. */
  static double[] pairs(
      Frame frame, double[] left, double[] right, DoubleBinaryOperator operation) {
    double[] values = zeros(frame, left.length);
    for (int i = 0; i < values.length; i++) {
      frame.job().worked(1);
      values[i] = operation.applyAsDouble(left[i], right[i]);
    }
    return values;
  }

  /** Converts values to numbers; errors name the argument at that place. */
  static double[] numbers(Frame frame, CallSite site, int place, List<UrbiObject> values) {
    double[] numbers = zeros(frame, values.size());
    for (int i = 0; i < numbers.length; i++) {
      frame.job().worked(1);
      UrbiObject value = values.get(i);
      if (!(value instanceof UrbiFloat number)) {
        throw Arguments.type(frame, site, place, value, "Float");
      }
      numbers[i] = number.value();
    }
    return numbers;
  }

  /** The numbers with commas between them. */
  static String text(Frame frame, double[] values, int from, int to) {
    StringBuilder text = new StringBuilder();
    for (int i = from; i < to; i++) {
      frame.job().worked(STEPS_FOR_NUMBER);
      text.append(i == from ? "" : ", ").append(FloatFormat.format(values[i]));
    }
    return text.toString();
  }

  /** Both must have the same size. */
  static void requireSame(Frame frame, CallSite site, boolean same) {
    if (!same) {
      throw frame.error(site, Problem.INCOMPATIBLE_SIZES);
    }
  }
}

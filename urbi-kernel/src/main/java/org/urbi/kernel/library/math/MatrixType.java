package org.urbi.kernel.library.math;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.library.value.Counting;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Matrices of numbers. */
@UrbiType(value = "Matrix", doc = "A matrix of numbers.", needs = Permission.NOTHING)
final class MatrixType {
  /** How many elements a matrix may have. */
  private static final int LARGEST = 1 << 24;

  private MatrixType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiMatrix(world.values().object.cloneShape(), 0, 0, new double[0]);
  }

  @Builtin(
      doc = "Of so many rows and columns of zeros; or of these rows, which are lists or vectors.",
      needs = Permission.CHANGE)
  static void init(Frame frame, CallSite site, UrbiMatrix self, UrbiObject... arguments) {
    if (arguments.length == 2
        && arguments[0] instanceof UrbiFloat rows
        && arguments[1] instanceof UrbiFloat columns) {
      int height = Counting.nonNegative(frame, site, 1, rows);
      int width = Counting.nonNegative(frame, site, 2, columns);
      self.set(height, width, zeros(frame, site, height, width));
      return;
    }
    List<double[]> rows = new ArrayList<>();
    for (int i = 0; i < arguments.length; i++) {
      double[] row = row(frame, site, i + 1, arguments[i]);
      Elementwise.requireSame(frame, site, rows.isEmpty() || rows.getFirst().length == row.length);
      rows.add(row);
    }
    self.set(rows.size(), rows.isEmpty() ? 0 : rows.getFirst().length, joined(frame, site, rows));
  }

  private static double[] joined(Frame frame, CallSite site, List<double[]> rows) {
    int width = rows.isEmpty() ? 0 : rows.getFirst().length;
    double[] all = zeros(frame, site, rows.size(), width);
    for (int i = 0; i < rows.size(); i++) {
      frame.job().worked(width);
      System.arraycopy(rows.get(i), 0, all, i * width, width);
    }
    return all;
  }

  /** The elements of such a matrix; an error if those are too many. */
  private static double[] zeros(Frame frame, CallSite site, int rows, int columns) {
    if ((long) rows * columns > LARGEST) {
      throw frame.error(site, Problem.MATRIX_TOO_LARGE);
    }
    return Elementwise.zeros(frame, rows * columns);
  }

  private static double[] row(Frame frame, CallSite site, int place, UrbiObject given) {
    return switch (given) {
      case UrbiVector vector -> vector.elements();
      case UrbiList list -> Elementwise.numbers(frame, site, place, list.elements());
      default -> throw Arguments.type(frame, site, place, given, "List");
    };
  }

  @Builtin(doc = "The number of rows.")
  static double size1(UrbiMatrix self) {
    return self.rows();
  }

  @Builtin(doc = "The number of columns.")
  static double size2(UrbiMatrix self) {
    return self.columns();
  }

  private static int place(Frame frame, CallSite site, UrbiMatrix self, int row, int column) {
    return Counting.index(frame, site, row, self.rows()) * self.columns()
        + Counting.index(frame, site, column, self.columns());
  }

  @Builtin(value = "[]", doc = "The element in a row and a column.")
  static double at(Frame frame, CallSite site, UrbiMatrix self, int row, int column) {
    return self.elements()[place(frame, site, self, row, column)];
  }

  @Builtin(
      value = "[]=",
      doc = "Replaces the element in a row and a column; returns the value.",
      needs = Permission.CHANGE)
  static double setAt(
      Frame frame, CallSite site, UrbiMatrix self, int row, int column, double value) {
    double[] changed = Elementwise.copy(frame, self.elements());
    changed[place(frame, site, self, row, column)] = value;
    self.set(self.rows(), self.columns(), changed);
    return value;
  }

  @Builtin(doc = "A row, as a vector.")
  static UrbiVector row(Frame frame, CallSite site, UrbiMatrix self, int index) {
    int from = Counting.index(frame, site, index, self.rows()) * self.columns();
    double[] values = Elementwise.zeros(frame, self.columns());
    System.arraycopy(self.elements(), from, values, 0, values.length);
    return vector(self, values);
  }

  @Builtin(doc = "A column, as a vector.")
  static UrbiVector column(Frame frame, CallSite site, UrbiMatrix self, int index) {
    int column = Counting.index(frame, site, index, self.columns());
    double[] values = Elementwise.zeros(frame, self.rows());
    for (int i = 0; i < values.length; i++) {
      frame.job().worked(1);
      values[i] = self.elements()[i * self.columns() + column];
    }
    return vector(self, values);
  }

  private static UrbiVector vector(UrbiMatrix self, double[] values) {
    return ((UrbiVector) self.world().prototype("Vector")).sibling(values);
  }

  @Builtin(doc = "The rows as columns.")
  static UrbiMatrix transpose(Frame frame, UrbiMatrix self) {
    double[] values = Elementwise.zeros(frame, self.elements().length);
    for (int i = 0; i < self.rows(); i++) {
      frame.job().worked(1 + self.columns());
      for (int j = 0; j < self.columns(); j++) {
        values[j * self.rows() + i] = self.elements()[i * self.columns() + j];
      }
    }
    return self.sibling(self.columns(), self.rows(), values);
  }

  private static UrbiMatrix combined(
      Frame frame,
      CallSite site,
      UrbiMatrix self,
      UrbiObject that,
      DoubleBinaryOperator operation) {
    double[] values =
        switch (that) {
          case UrbiFloat number ->
              Elementwise.each(frame, self.elements(), number.value(), operation);
          case UrbiMatrix other -> {
            boolean same = other.rows() == self.rows() && other.columns() == self.columns();
            Elementwise.requireSame(frame, site, same);
            yield Elementwise.pairs(frame, self.elements(), other.elements(), operation);
          }
          default -> throw Arguments.type(frame, site, 1, that, "Matrix");
        };
    return self.sibling(self.rows(), self.columns(), values);
  }

  @Builtin(value = "+", doc = "The sum with a matrix, or with a number for each element.")
  static UrbiMatrix plus(Frame frame, CallSite site, UrbiMatrix self, UrbiObject that) {
    return combined(frame, site, self, that, (x, y) -> x + y);
  }

  @Builtin(value = "-", doc = "The difference to a matrix, or to a number for each element.")
  static UrbiMatrix minus(Frame frame, CallSite site, UrbiMatrix self, UrbiObject that) {
    return combined(frame, site, self, that, (x, y) -> x - y);
  }

  @Builtin(value = "/", doc = "The quotient of each element by a number.")
  static UrbiMatrix divided(Frame frame, CallSite site, UrbiMatrix self, double that) {
    return self.sibling(
        self.rows(),
        self.columns(),
        Elementwise.each(frame, self.elements(), that, (x, y) -> x / y));
  }

  @Builtin(value = "*", doc = "The product with a matrix, a vector, or a number.")
  static UrbiObject times(Frame frame, CallSite site, UrbiMatrix self, UrbiObject that) {
    return switch (that) {
      case UrbiVector vector -> {
        Elementwise.requireSame(frame, site, self.columns() == vector.elements().length);
        yield vector.sibling(product(frame, site, self, vector.elements(), 1));
      }
      case UrbiMatrix other -> {
        Elementwise.requireSame(frame, site, self.columns() == other.rows());
        yield self.sibling(
            self.rows(),
            other.columns(),
            product(frame, site, self, other.elements(), other.columns()));
      }
      default -> combined(frame, site, self, that, (x, y) -> x * y);
    };
  }

  /** The product with a matrix of that number of columns. */
  private static double[] product(
      Frame frame, CallSite site, UrbiMatrix left, double[] right, int width) {
    double[] values = zeros(frame, site, left.rows(), width);
    for (int i = 0; i < left.rows(); i++) {
      for (int j = 0; j < width; j++) {
        frame.job().worked(1 + left.columns());
        for (int k = 0; k < left.columns(); k++) {
          values[i * width + j] += left.elements()[i * left.columns() + k] * right[k * width + j];
        }
      }
    }
    return values;
  }

  @Builtin(value = "==", doc = "Whether both have the same size and the same elements.")
  static boolean equal(UrbiMatrix self, UrbiObject that) {
    return that instanceof UrbiMatrix other
        && self.rows() == other.rows()
        && self.columns() == other.columns()
        && Arrays.equals(self.elements(), other.elements());
  }

  @Builtin(value = "!=", doc = "Whether they differ in size or in an element.")
  static boolean differs(UrbiMatrix self, UrbiObject that) {
    return !equal(self, that);
  }

  @Builtin(doc = "The rows, as Matrix.new takes them.")
  static String asString(Frame frame, UrbiMatrix self) {
    List<String> rows = new ArrayList<>();
    for (int i = 0; i < self.rows(); i++) {
      frame.job().worked(Steps.OBJECT);
      int from = i * self.columns();
      rows.add("[" + Elementwise.text(frame, self.elements(), from, from + self.columns()) + "]");
    }
    return "Matrix(" + String.join(", ", rows) + ")";
  }
}

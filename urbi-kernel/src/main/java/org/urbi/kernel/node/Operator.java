package org.urbi.kernel.node;

import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.lang.source.Span;

/**
 * An operator between two operands. It is a message like any other; but when both are plain numbers
 * and nobody has redefined the operator of numbers, it is computed here.
 */
public abstract class Operator extends Node {
  final Node left;
  final Node right;
  final Message message;
  final Values values;
  private final Symbol name;
  private final UrbiObject original;
  private int intactEpoch = -1;

  /** The value of a right operand that is a literal, which needs no object then; or NaN. */
  final double literal;

  private Operator(
      Span span, Node left, Node right, Message message, Values values, UrbiObject original) {
    super(span);
    this.left = left;
    this.right = right;
    this.message = message;
    this.name = message.name();
    this.values = values;
    this.original = original;
    this.literal = right instanceof Literals.Number number ? number.value() : Double.NaN;
  }

  /** The value for two numbers. */
  abstract UrbiObject compute(Values values, double a, double b);

  @Override
  public final UrbiObject execute(Frame frame) {
    UrbiObject a = left.execute(frame);
    if (a instanceof UrbiFloat x && a.shape() == values.floatShape && isIntact()) {
      if (!Double.isNaN(literal)) {
        return compute(values, x.value(), literal);
      }
      UrbiObject b = right.execute(frame);
      if (b instanceof UrbiFloat y && b.shape() == values.floatShape) {
        return compute(values, x.value(), y.value());
      }
      return message.sendTo(frame, a, b);
    }
    return message.sendTo(frame, a);
  }

  /** Whether the operator of numbers is the one of the library. */
  final boolean isIntact() {
    int epoch = name.epoch();
    if (epoch != intactEpoch) {
      if (values.floatProto.world().profiled || values.floatProto.lookup(name) != original) {
        return false;
      }
      intactEpoch = epoch;
    }
    return true;
  }

  /** The operator of that name computed in place, or null if there is no such. */
  public static Node make(
      Span span, Node left, Node right, Message message, Interpreter interpreter) {
    Values values = interpreter.values();
    UrbiObject original = interpreter.operatorOfNumbers(message.name());
    if (original == null) {
      return null;
    }
    return switch (message.name().name()) {
      case "+" ->
          new Operator(span, left, right, message, values, original) {
            @Override
            UrbiObject compute(Values values, double a, double b) {
              return values.number(a + b);
            }
          };
      case "-" ->
          new Operator(span, left, right, message, values, original) {
            @Override
            UrbiObject compute(Values values, double a, double b) {
              return values.number(a - b);
            }
          };
      case "*" ->
          new Operator(span, left, right, message, values, original) {
            @Override
            UrbiObject compute(Values values, double a, double b) {
              return values.number(a * b);
            }
          };
      case "<" ->
          new Comparison(span, left, right, message, values, original) {
            @Override
            boolean holds(double a, double b) {
              return a < b;
            }
          };
      case "<=" ->
          new Comparison(span, left, right, message, values, original) {
            @Override
            boolean holds(double a, double b) {
              return a <= b;
            }
          };
      case ">" ->
          new Comparison(span, left, right, message, values, original) {
            @Override
            boolean holds(double a, double b) {
              return a > b;
            }
          };
      case ">=" ->
          new Comparison(span, left, right, message, values, original) {
            @Override
            boolean holds(double a, double b) {
              return a >= b;
            }
          };
      case "==" ->
          new Comparison(span, left, right, message, values, original) {
            @Override
            boolean holds(double a, double b) {
              return a == b;
            }
          };
      case "!=" ->
          new Comparison(span, left, right, message, values, original) {
            @Override
            boolean holds(double a, double b) {
              return a != b;
            }
          };
      default -> null;
    };
  }

  /** A comparison, which a condition needs no Boolean object for. */
  private abstract static class Comparison extends Operator {
    Comparison(
        Span span, Node left, Node right, Message message, Values values, UrbiObject original) {
      super(span, left, right, message, values, original);
    }

    abstract boolean holds(double a, double b);

    @Override
    final UrbiObject compute(Values known, double a, double b) {
      return known.bool(holds(a, b));
    }

    @Override
    public final boolean test(Frame frame) {
      UrbiObject a = left.execute(frame);
      if (a instanceof UrbiFloat x && a.shape() == values.floatShape && isIntact()) {
        if (!Double.isNaN(literal)) {
          return holds(x.value(), literal);
        }
        UrbiObject b = right.execute(frame);
        if (b instanceof UrbiFloat y && b.shape() == values.floatShape) {
          return holds(x.value(), y.value());
        }
        return Truth.of(frame, message.sendTo(frame, a, b));
      }
      return Truth.of(frame, message.sendTo(frame, a));
    }
  }
}

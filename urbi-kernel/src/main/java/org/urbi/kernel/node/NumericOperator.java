package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.object.World;
import org.urbi.lang.source.Span;

/**
 * An operator between two operands. It is a message like any other; but when both are plain numbers
 * and nobody has redefined the operator of numbers, it is computed here.
 *
 * <p>The kinds are told apart by a switch, not by subclasses: a call which all operators share
 * would be megamorphic, and cost more than what it computes.
 */
public final class NumericOperator extends Node {
  private static final int ADD = 0;
  private static final int SUBTRACT = 1;
  private static final int MULTIPLY = 2;
  private static final int DIVIDE = 3;
  private static final int MODULO = 4;
  private static final int POWER = 5;
  private static final int LESS = 6;
  private static final int LESS_OR_EQUAL = 7;
  private static final int GREATER = 8;
  private static final int GREATER_OR_EQUAL = 9;
  private static final int EQUAL = 10;
  private static final int DIFFERENT = 11;

  private final int kind;
  private final Node left;
  private final Node right;
  private final MessageSend message;
  private final Values values;
  private final Symbol name;
  private final @Nullable UrbiObject original;
  private final Symbol equality;
  private final EqualityCache objects;
  private final EqualityCache texts;
  private int intactEpoch = -1;

  /** The index of the left operand if it is a plain local variable, or -1. */
  private final int local;

  /**
   * The value of the right operand if it is a literal, for which no object is created then; or NaN.
   */
  private final double literal;

  private NumericOperator(
      Span span,
      int kind,
      Node left,
      Node right,
      MessageSend message,
      Values values,
      @Nullable UrbiObject original) {
    super(span);
    this.kind = kind;
    this.left = left;
    this.right = right;
    this.message = message;
    this.name = message.name();
    this.values = values;
    this.equality = values.floatProto.world().symbol("==");
    this.objects = new EqualityCache(name, equality);
    this.texts = new EqualityCache(name, equality);
    this.original = original;
    this.local = left instanceof Variables.Local variable ? variable.index() : -1;
    this.literal =
        right instanceof Literals.Number number && computes(number.value())
            ? number.value()
            : Double.NaN;
  }

  /** Creates the node for an operator that can be computed in place; null for other operators. */
  public static @Nullable Node make(
      Span span, Node left, Node right, MessageSend message, Interpreter interpreter) {
    UrbiObject original = interpreter.operatorOfNumbers(message.name());
    int kind = original == null ? -1 : kind(message.name().name());
    return kind < 0
        ? null
        : new NumericOperator(span, kind, left, right, message, interpreter.values(), original);
  }

  private static int kind(String name) {
    return switch (name) {
      case "+" -> ADD;
      case "-" -> SUBTRACT;
      case "*" -> MULTIPLY;
      case "/" -> DIVIDE;
      case "%" -> MODULO;
      case "**" -> POWER;
      case "<" -> LESS;
      case "<=" -> LESS_OR_EQUAL;
      case ">" -> GREATER;
      case ">=" -> GREATER_OR_EQUAL;
      case "==" -> EQUAL;
      case "!=" -> DIFFERENT;
      default -> -1;
    };
  }

  public Node left() {
    return left;
  }

  public Node right() {
    return right;
  }

  /** The operator's name. */
  public Symbol name() {
    return name;
  }

  /** The operator as a message, for operands that are no plain numbers. */
  public MessageSend message() {
    return message;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    UrbiObject a = leftValue(frame);
    if (a instanceof UrbiFloat x && a.shape() == values.floatShape && isIntact()) {
      if (!Double.isNaN(literal)) {
        return compute(x.value(), literal);
      }
      UrbiObject b = right.execute(frame);
      if (b instanceof UrbiFloat y && b.shape() == values.floatShape && computes(y.value())) {
        return compute(x.value(), y.value());
      }
      return message.sendTo(frame, a, b);
    }
    return equates(frame, a) ? values.bool(isSame(frame, a)) : message.sendTo(frame, a);
  }

  /** Whether the operator is one of the library by which any objects, or strings, are compared. */
  boolean equates(Frame frame, UrbiObject left) {
    return isKnown(left) || mayEquate(frame.interpreter.world()) && finds(frame, left);
  }

  /**
   * Whether it has been one of these for such an object; to ask that has no effect. A long string
   * must be {@linkplain #equates asked for} each time, since to compare it takes longer than code
   * may that just counts its turns.
   */
  boolean equatesAsBefore(UrbiObject left) {
    return !(left instanceof UrbiString text && !text.isShort()) && isKnown(left);
  }

  private boolean isKnown(UrbiObject left) {
    return mayEquate(left.world()) && cache(left).has(left.shape());
  }

  private boolean mayEquate(World world) {
    return kind >= EQUAL && world.tracker == null && !world.profiled;
  }

  private EqualityCache cache(UrbiObject left) {
    return left instanceof UrbiString ? texts : objects;
  }

  private boolean finds(Frame frame, UrbiObject left) {
    UrbiObject found = stored(left, name);
    if (found == null) {
      return false;
    }
    boolean equates =
        left instanceof UrbiString
            ? frame.interpreter.comparesText(found)
            : frame.interpreter.comparesIdentity(found, stored(left, equality));
    if (equates) {
      cache(left).add(frame.interpreter.world(), left.shape());
    }
    return equates;
  }

  /** The value of a slot, or null if there is none, or a getter. */
  private static @Nullable UrbiObject stored(UrbiObject target, Symbol name) {
    UrbiObject holder = target.locate(name);
    if (holder == null) {
      return null;
    }
    int index = holder.shape().indexOf(name);
    return holder.shape().readSpecial(index) ? null : holder.slotAt(index);
  }

  private boolean isSame(Frame frame, UrbiObject left) {
    UrbiObject other = right.execute(frame);
    try {
      return isSame(left, frame.interpreter.notVoid(other));
    } catch (UrbiException e) {
      throw frame.located(e, message.span());
    }
  }

  /** The answer of an operator that {@linkplain #equates equates} the left operand. */
  boolean isSame(UrbiObject left, UrbiObject right) {
    boolean same =
        left instanceof UrbiString text
            ? right instanceof UrbiString other && text.value().equals(other.value())
            : left == right;
    return same == (kind == EQUAL);
  }

  /** As a condition, a comparison creates no Boolean object. */
  @Override
  public boolean test(Frame frame) {
    if (!isComparison()) {
      return super.test(frame);
    }
    UrbiObject a = leftValue(frame);
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
    return equates(frame, a) ? isSame(frame, a) : Truth.of(frame, message.sendTo(frame, a));
  }

  /** The left operand; a local variable is read here, which saves a call. */
  private UrbiObject leftValue(Frame frame) {
    if (local >= 0 && frame.locals[local] instanceof UrbiFloat number) {
      return number;
    }
    return left.execute(frame);
  }

  /** Whether a division by 0 may follow, which is an error. */
  public boolean divides() {
    return kind == DIVIDE || kind == MODULO;
  }

  private boolean computes(double divisor) {
    return divisor != 0 || !divides();
  }

  /** Whether it is {@code ==} or {@code !=}. */
  public boolean isEquality() {
    return kind >= EQUAL;
  }

  /** Whether its result is a Boolean. */
  public boolean isComparison() {
    return kind >= LESS;
  }

  private UrbiObject compute(double a, double b) {
    return switch (kind) {
      case ADD -> values.number(a + b);
      case SUBTRACT -> values.number(a - b);
      case MULTIPLY -> values.number(a * b);
      case DIVIDE -> values.number(a / b);
      case MODULO -> values.number(a % b);
      case POWER -> values.number(Math.pow(a, b));
      default -> values.bool(holds(a, b));
    };
  }

  private boolean holds(double a, double b) {
    return switch (kind) {
      case LESS -> a < b;
      case LESS_OR_EQUAL -> a <= b;
      case GREATER -> a > b;
      case GREATER_OR_EQUAL -> a >= b;
      case EQUAL -> a == b;
      default -> a != b;
    };
  }

  /** Whether the operator of numbers is still the library's. */
  public boolean isIntact() {
    int epoch = name.epoch();
    if (epoch != intactEpoch) {
      if (values.floatProto.world().profiled || values.floatProto.lookup(name) != original) {
        return false;
      }
      intactEpoch = values.floatProto.world().remember(name);
    }
    return true;
  }
}

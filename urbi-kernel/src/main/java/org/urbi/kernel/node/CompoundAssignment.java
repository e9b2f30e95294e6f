package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.lang.source.Span;

/**
 * {@code a += b}, which is {@code a = a.'+='(b)}, and {@code a++}, which sets {@code a} to {@code
 * a.'++'} and returns its former value. The parts of {@code a} are evaluated only once.
 */
public final class CompoundAssignment extends Node implements CallSite {
  /** What is modified. */
  public sealed interface Access {
    /** Evaluates the parts: an array with the target, then the others. */
    UrbiObject[] parts(Frame frame);

    UrbiObject read(Frame frame, UrbiObject[] parts);

    /**
     * Assigns it.
     *
     * @return the value of the assignment, which a slot may have corrected
     */
    UrbiObject write(Frame frame, UrbiObject[] parts, UrbiObject value);
  }

  /** A local variable. */
  public record OfVariable(Node variable, Variables.Place place) implements Access {
    @Override
    public UrbiObject[] parts(Frame frame) {
      return Frame.NO_ARGUMENTS;
    }

    @Override
    public UrbiObject read(Frame frame, UrbiObject[] parts) {
      return variable.execute(frame);
    }

    @Override
    public UrbiObject write(Frame frame, UrbiObject[] parts, UrbiObject value) {
      place.assign(frame, value);
      return value;
    }
  }

  /** A slot. */
  public record Slot(Node target, SlotLookup lookup, Slots.Assign writer) implements Access {
    public Slot(Node target, SlotLookup lookup, Span span) {
      // It is given the value.
      this(
          target,
          lookup,
          new Slots.Assign(span, span, target, lookup.name(), new Sequences.Noop(span)));
    }

    @Override
    public UrbiObject[] parts(Frame frame) {
      return new UrbiObject[] {target.execute(frame)};
    }

    @Override
    public UrbiObject read(Frame frame, UrbiObject[] parts) {
      UrbiObject value = lookup.find(frame, parts[0]);
      if (value == null) {
        return frame.interpreter.send(frame, parts[0], lookup.name().name());
      }
      return value instanceof Code code ? frame.interpreter.call(frame, code, parts[0]) : value;
    }

    @Override
    public UrbiObject write(Frame frame, UrbiObject[] parts, UrbiObject value) {
      return writer.assign(frame, parts[0], value);
    }
  }

  /** {@code a[i]}. */
  public record Element(Node target, Node[] indices, SlotLookup get, SlotLookup set)
      implements Access {
    @Override
    public UrbiObject[] parts(Frame frame) {
      UrbiObject[] parts = new UrbiObject[1 + indices.length];
      parts[0] = target.execute(frame);
      for (int i = 0; i < indices.length; i++) {
        parts[i + 1] = frame.interpreter.notVoid(indices[i].execute(frame));
      }
      return parts;
    }

    @Override
    public UrbiObject read(Frame frame, UrbiObject[] parts) {
      return frame.interpreter.send(frame, parts[0], get, tail(parts, null));
    }

    @Override
    public UrbiObject write(Frame frame, UrbiObject[] parts, UrbiObject value) {
      frame.interpreter.send(frame, parts[0], set, tail(parts, value));
      return value;
    }

    private static UrbiObject[] tail(UrbiObject[] parts, @Nullable UrbiObject last) {
      UrbiObject[] tail = new UrbiObject[parts.length - (last == null ? 1 : 0)];
      System.arraycopy(parts, 1, tail, 0, parts.length - 1);
      if (last != null) {
        tail[tail.length - 1] = last;
      }
      return tail;
    }
  }

  /** A property of a slot. */
  public record OfProperty(Node target, Symbol slot, String property) implements Access {
    @Override
    public UrbiObject[] parts(Frame frame) {
      return new UrbiObject[] {target.execute(frame)};
    }

    @Override
    public UrbiObject read(Frame frame, UrbiObject[] parts) {
      return Properties.get(frame, parts[0], slot, property);
    }

    @Override
    public UrbiObject write(Frame frame, UrbiObject[] parts, UrbiObject value) {
      Properties.set(frame, parts[0], slot, property, value);
      return value;
    }
  }

  /** A value that cannot be assigned: only the operator is called. */
  public record Constant(Node value) implements Access {
    @Override
    public UrbiObject[] parts(Frame frame) {
      return Frame.NO_ARGUMENTS;
    }

    @Override
    public UrbiObject read(Frame frame, UrbiObject[] parts) {
      return value.execute(frame);
    }

    @Override
    public UrbiObject write(Frame frame, UrbiObject[] parts, UrbiObject written) {
      return written;
    }
  }

  private final Access access;
  private final Symbol operator;
  private final @Nullable Node operand;
  private final Values values;
  private final int sign;
  private final @Nullable UrbiObject original;
  private int intactEpoch = -1;

  /** The index of the plain local variable that is modified, or -1 for anything else. */
  private final int local;

  /** The number that is added, if it is a constant; otherwise NaN. */
  private final double step;

  /**
   * @param operand null for the postfix operators
   */
  public CompoundAssignment(
      Span span, Interpreter interpreter, Access access, String operator, @Nullable Node operand) {
    super(span);
    this.access = access;
    this.operator = interpreter.world().symbol(operator);
    this.operand = operand;
    this.values = interpreter.values();
    this.sign =
        switch (operator) {
          case "+=", "++" -> 1;
          case "-=", "--" -> -1;
          default -> 0;
        };
    this.original = values.floatProto.lookup(this.operator);
    this.local = access instanceof OfVariable variable ? variable.place().local() : -1;
    this.step = sign == 0 ? Double.NaN : sign * stepOf(operand);
  }

  private static double stepOf(@Nullable Node operand) {
    if (operand == null) {
      return 1;
    }
    return operand instanceof Literals.Number number ? number.value() : Double.NaN;
  }

  /** What is modified. */
  public Access access() {
    return access;
  }

  /** The index of the plain local variable that is modified, or -1 for anything else. */
  public int local() {
    return local;
  }

  /** What is combined with the former value; null for {@code ++} and {@code --}. */
  public @Nullable Node operand() {
    return operand;
  }

  /** 1 if it adds, -1 if it subtracts, otherwise 0. */
  public int sign() {
    return sign;
  }

  public Symbol operator() {
    return operator;
  }

  @Override
  public String calledName() {
    return operator.name();
  }

  @Override
  public Span calledSpan() {
    return span();
  }

  @Override
  public UrbiObject execute(Frame frame) {
    if (local >= 0 && sign != 0 && frame.locals[local] instanceof UrbiFloat before) {
      return count(frame, before);
    }
    return modify(frame);
  }

  /** The fast path for a number in a plain local variable. */
  private UrbiObject count(Frame frame, UrbiFloat before) {
    if (!Double.isNaN(step) && before.shape() == values.floatShape && isIntact()) {
      UrbiObject after = values.number(before.value() + step);
      frame.locals[local] = after;
      return operand == null ? before : after;
    }
    try {
      UrbiObject after =
          operand == null
              ? successor(frame, before)
              : combined(frame, before, ArgumentEvaluation.notVoid(frame, operand, span()));
      SharedLocal.store(frame.locals, local, after);
      return operand == null ? before : after;
    } catch (UrbiException e) {
      throw frame.located(e, span());
    }
  }

  /** The general way, for all places and operators. */
  private UrbiObject modify(Frame frame) {
    try {
      UrbiObject[] parts = access.parts(frame);
      UrbiObject before = access.read(frame, parts);
      if (operand == null) {
        access.write(frame, parts, successor(frame, before));
        return before;
      }
      UrbiObject after =
          combined(frame, before, ArgumentEvaluation.notVoid(frame, operand, span()));
      return access.write(frame, parts, after);
    } catch (UrbiException e) {
      throw frame.located(e, span());
    }
  }

  UrbiObject successor(Frame frame, UrbiObject before) {
    if (before instanceof UrbiFloat number && before.shape() == values.floatShape && isIntact()) {
      return values.number(number.value() + sign);
    }
    return frame.interpreter.send(frame, this, before, operator);
  }

  UrbiObject combined(Frame frame, UrbiObject before, UrbiObject by) {
    if (sign != 0
        && before instanceof UrbiFloat a
        && by instanceof UrbiFloat b
        && before.shape() == values.floatShape
        && by.shape() == values.floatShape
        && isIntact()) {
      return values.number(a.value() + sign * b.value());
    }
    return frame.interpreter.send(frame, this, before, operator, by);
  }

  /** Whether the operator of numbers is still the library's. */
  public boolean isIntact() {
    int epoch = operator.epoch();
    if (epoch != intactEpoch) {
      if (values.floatProto.world().profiled || values.floatProto.lookup(operator) != original) {
        return false;
      }
      intactEpoch = values.floatProto.world().remember(operator);
    }
    return true;
  }
}

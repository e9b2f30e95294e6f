package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code if}, {@code &&}, {@code ||}. */
public final class Conditionals {
  private Conditionals() {}

  /** {@code if (condition) thenClause else elseClause}. */
  public static final class If extends Node {
    private final Node condition;
    private final Node thenClause;
    private final @Nullable Node elseClause;

    /**
     * @param elseClause may be null
     */
    public If(Span span, Node condition, Node thenClause, @Nullable Node elseClause) {
      super(span);
      this.condition = condition;
      this.thenClause = thenClause;
      this.elseClause = elseClause;
    }

    public Node condition() {
      return condition;
    }

    public Node thenClause() {
      return thenClause;
    }

    public @Nullable Node elseClause() {
      return elseClause;
    }

    @Override
    void standsIn(@Nullable TurnCount loop) {
      thenClause.standsIn(loop);
      if (elseClause != null) {
        elseClause.standsIn(loop);
      }
    }

    @Override
    public UrbiObject execute(Frame frame) {
      boolean holds;
      try {
        holds = condition.test(frame);
      } catch (UrbiException e) {
        throw frame.located(e, span());
      }
      if (holds) {
        return thenClause.execute(frame);
      }
      return elseClause == null ? frame.interpreter.values().voidObject : elseClause.execute(frame);
    }
  }

  /** {@code a && b} and {@code a || b}: the value of the operand that decides. */
  public static final class Logical extends Node {
    private final boolean and;
    private final Node left;
    private final Node right;

    public Logical(Span span, boolean and, Node left, Node right) {
      super(span);
      this.and = and;
      this.left = left;
      this.right = right;
    }

    /** Whether it is {@code &&}. */
    public boolean isAnd() {
      return and;
    }

    public Node left() {
      return left;
    }

    public Node right() {
      return right;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject value = left.execute(frame);
      boolean holds;
      try {
        holds = Truth.of(frame, value);
      } catch (UrbiException e) {
        throw frame.located(e, left.span());
      }
      return holds == and ? right.execute(frame) : value;
    }

    @Override
    public boolean test(Frame frame) {
      return left.test(frame) == and ? right.test(frame) : !and;
    }
  }
}

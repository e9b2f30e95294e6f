package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code switch}, and assignment to a pattern. */
public final class Matching {
  private Matching() {}

  /**
   * A {@code case} of a switch.
   *
   * @param guard may be null
   */
  public record Case(Pattern pattern, @Nullable Node guard, Node body) {}

  /** {@code switch (value) {…}}: the value of the case that matches. */
  public static final class Switch extends Node {
    private final Node value;
    private final Case[] cases;
    private final @Nullable Node defaultCase;

    /**
     * @param defaultCase may be null
     */
    public Switch(Span span, Node value, Case[] cases, @Nullable Node defaultCase) {
      super(span);
      this.value = value;
      this.cases = cases;
      this.defaultCase = defaultCase;
    }

    public Node value() {
      return value;
    }

    public Case[] cases() {
      return cases;
    }

    public @Nullable Node defaultCase() {
      return defaultCase;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject switched = ArgumentEvaluation.notVoid(frame, value, span());
      for (Case one : cases) {
        if (one.pattern.matches(frame, switched) && (one.guard == null || one.guard.test(frame))) {
          return one.body.execute(frame);
        }
      }
      return defaultCase == null
          ? frame.interpreter.values().voidObject
          : defaultCase.execute(frame);
    }
  }

  /** {@code [var a, var b] = value}. */
  public static final class Destructure extends Node {
    private final Pattern pattern;
    private final Node value;

    public Destructure(Span span, Pattern pattern, Node value) {
      super(span);
      this.pattern = pattern;
      this.value = value;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject matched = ArgumentEvaluation.notVoid(frame, value, span());
      if (!pattern.matches(frame, matched)) {
        throw frame.located(frame.interpreter.errors().matchFailure(), span());
      }
      return matched;
    }
  }

  /** Code that matches a value against a pattern, and declares slots when it has matched. */
  public static final class DeclaringSlots extends Node {
    private final Node matching;
    private final Node[] declarations;

    public DeclaringSlots(Node matching, Node[] declarations) {
      super(matching.span());
      this.matching = matching;
      this.declarations = declarations;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject value = matching.execute(frame);
      for (Node declaration : declarations) {
        declaration.execute(frame);
      }
      return value;
    }
  }

  /** A pattern that is not declared but assigned: {@code [a, b] = [b, a]}. */
  public static final class AssignedPlace extends Pattern {
    private final Variables.Place place;

    public AssignedPlace(Variables.Place place) {
      this.place = place;
    }

    @Override
    public void tell(Parts parts) {
      parts.variable(place);
    }

    @Override
    public boolean matches(Frame frame, UrbiObject value) {
      place.assign(frame, value);
      return true;
    }
  }
}

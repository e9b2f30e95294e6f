package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code target.name(arguments)}: finds the slot, and calls it if it is a function. */
public final class MessageSend extends Node implements CallSite {
  private static final Node[] NONE = {};

  private final @Nullable Node target;
  private final Node[] arguments;
  private final SlotLookup lookup;

  /**
   * @param target null for {@code this}
   * @param arguments null when there are no parentheses
   */
  public MessageSend(
      Span span, SlotLookup lookup, @Nullable Node target, Node @Nullable [] arguments) {
    super(span);
    this.lookup = lookup;
    this.target = target;
    this.arguments = arguments == null ? NONE : arguments;
  }

  Symbol name() {
    return lookup.name();
  }

  /** How the slot is found. */
  public SlotLookup lookup() {
    return lookup;
  }

  /** The target; null for {@code this}. */
  public @Nullable Node target() {
    return target;
  }

  /** The value of the slot, or null; a getter is called. */
  @Nullable UrbiObject find(Frame frame, UrbiObject receiver) {
    return lookup.find(frame, receiver);
  }

  @Override
  public String calledName() {
    return lookup.name().name();
  }

  @Override
  public Span calledSpan() {
    return span();
  }

  @Override
  public Node[] argumentNodes() {
    return arguments;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    return sendTo(frame, target == null ? frame.self : target.execute(frame));
  }

  /** Sends the message to a target that has been evaluated. */
  UrbiObject sendTo(Frame frame, UrbiObject receiver) {
    try {
      return answer(frame, lookup.find(frame, receiver), receiver);
    } catch (UrbiException e) {
      throw frame.located(e, span());
    }
  }

  /**
   * Calls what was found for a target.
   *
   * @param found null if the target has no such slot
   */
  UrbiObject answer(Frame frame, @Nullable UrbiObject found, UrbiObject receiver) {
    if (found instanceof Code code) {
      return Calls.call(frame, this, code, receiver, arguments);
    }
    if (found == null) {
      return Calls.fallback(frame, this, receiver, name(), arguments);
    }
    return Calls.plain(frame, this, found, receiver, arguments);
  }

  /** Sends the message with an argument that has been evaluated, too. */
  UrbiObject sendTo(Frame frame, UrbiObject receiver, UrbiObject argument) {
    try {
      frame.interpreter.notVoid(argument);
      return frame.interpreter.send(frame, this, receiver, name(), argument);
    } catch (UrbiException e) {
      throw frame.located(e, span());
    }
  }

  /** A local variable called as a function, on the current target. */
  public static final class OfLocal extends Node implements CallSite {
    private final String name;
    private final Node variable;
    private final Node[] arguments;

    /** The code of the function that was called last; or null. */
    private Function.@Nullable Body called;

    public OfLocal(Span span, String name, Node variable, Node[] arguments) {
      super(span);
      this.name = name;
      this.variable = variable;
      this.arguments = arguments;
    }

    @Override
    public String calledName() {
      return name;
    }

    @Override
    public Span calledSpan() {
      return span();
    }

    @Override
    public Node[] argumentNodes() {
      return arguments;
    }

    /** The variable. */
    public Node variable() {
      return variable;
    }

    /** The code of the function that was called last; null if none was. */
    public Function.@Nullable Body called() {
      return called;
    }

    /** Calls the value of the variable. */
    UrbiObject answer(Frame frame, UrbiObject value) {
      if (value instanceof Function function) {
        called = function.body();
      }
      return value instanceof Code code
          ? Calls.call(frame, this, code, frame.self, arguments)
          : Calls.plain(frame, this, value, frame.self, arguments);
    }

    @Override
    public UrbiObject execute(Frame frame) {
      try {
        return answer(frame, variable.execute(frame));
      } catch (UrbiException e) {
        throw frame.located(e, span());
      }
    }
  }
}

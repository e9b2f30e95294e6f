package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.object.Dependencies;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** Local variables: plain ones in the frame, shared ones in cells. */
public final class Variables {
  private Variables() {}

  /** The cell with that index in the frame; a negative index means a captured variable. */
  static Cell cell(Frame frame, int index) {
    if (index < 0) {
      return frame.captured()[-1 - index];
    }
    Cell cell = frame.cells[index];
    if (cell == null) {
      cell = new Cell(frame.interpreter.values().voidObject);
      frame.cells[index] = cell;
    }
    return cell;
  }

  /** Reads a plain variable. */
  public static final class Local extends Node {
    private final int index;

    public Local(Span span, int index) {
      super(span);
      this.index = index;
    }

    /** The index of the variable among the locals of the frame. */
    public int index() {
      return index;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      @Nullable UrbiObject value = frame.locals[index];
      if (value instanceof SharedLocal shared) {
        return shared.get();
      }
      return value == null ? frame.interpreter.values().voidObject : value;
    }
  }

  /** Reads a shared variable. */
  public static final class Shared extends Node {
    private final int index;

    public Shared(Span span, int index) {
      super(span);
      this.index = index;
    }

    /** The number of the variable among those that the function has captured, or a negative one. */
    public int captured() {
      return -1 - index;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      Cell cell = cell(frame, index);
      Dependencies.Tracker tracker = frame.interpreter.world().tracker;
      return tracker == null ? cell.get() : cell.getTracked(tracker);
    }
  }

  /** The storage of a variable. */
  public static final class Place {
    private final int index;
    private final boolean shared;
    private final boolean begun;
    private final boolean constant;

    /**
     * @param begun whether the variable exists before its declaration is executed, because another
     *     job executes that
     * @param constant whether it cannot be assigned
     */
    public Place(int index, boolean shared, boolean begun, boolean constant) {
      this.index = index;
      this.shared = shared;
      this.begun = begun;
      this.constant = constant;
    }

    /**
     * The index among the locals of the frame if it is a plain variable that is not constant, or
     * -1.
     */
    public int local() {
      return shared || constant ? -1 : index;
    }

    /** The index among the locals of the frame if it is a plain variable, or -1. */
    public int declaredLocal() {
      return shared ? -1 : index;
    }

    /**
     * The number of the variable among those that the function has captured; negative if it has not
     * captured it, or if it is constant.
     */
    public int captured() {
      return shared && !constant ? -1 - index : -1;
    }

    /** Creates the variable. */
    public void declare(Frame frame, UrbiObject value) {
      if (begun) {
        store(frame, value);
      } else if (shared) {
        frame.cells[index] = new Cell(value);
      } else {
        // A frame of compiled code, of which nobody needs to see variables, has no room before.
        FrameAccess.locals(frame)[index] = value;
      }
    }

    /**
     * Assigns the variable.
     *
     * @throws org.urbi.kernel.error.UrbiException when it is constant
     */
    void assign(Frame frame, UrbiObject value) {
      if (constant) {
        throw frame.interpreter.errors().constness();
      }
      store(frame, value);
    }

    private void store(Frame frame, UrbiObject value) {
      if (shared) {
        cell(frame, index).set(value);
      } else {
        SharedLocal.store(frame.locals, index, value);
      }
    }
  }

  /** {@code var x = value}. */
  public static final class Declare extends Node {
    private final Place place;
    private final @Nullable Node value;
    private final @Nullable Node type;
    private final String name;

    /**
     * @param span the location of the name
     * @param value null for void
     * @param type the type that it must have, or null
     */
    public Declare(Span span, String name, Place place, @Nullable Node value, @Nullable Node type) {
      super(span);
      this.name = name;
      this.place = place;
      this.value = value;
      this.type = type;
    }

    public Place place() {
      return place;
    }

    /** The initial value; null for void. */
    public @Nullable Node value() {
      return value;
    }

    /** Whether the value must be of a type. */
    public boolean isTyped() {
      return type != null;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject initial = initialValue(frame, value, span());
      if (type != null && value != null) {
        TypeCheck.check(frame, name, 1, initial, type.execute(frame));
      }
      place.declare(frame, initial);
      return initial;
    }
  }

  /** {@code function f() {…}} in a scope: the function can call itself. */
  public static final class DeclareRecursive extends Node {
    private final Place place;
    private final Node function;

    public DeclareRecursive(Span span, Place place, Node function) {
      super(span);
      this.place = place;
      this.function = function;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      // Create the variable before the function captures it.
      place.declare(frame, frame.interpreter.values().voidObject);
      UrbiObject value = function.execute(frame);
      place.assign(frame, value);
      return value;
    }
  }

  /**
   * The initial value of a variable: void if none is given. An expression that evaluates to void is
   * an error.
   */
  static UrbiObject initialValue(Frame frame, @Nullable Node value, Span at) {
    return value == null
        ? frame.interpreter.values().voidObject
        : ArgumentEvaluation.notVoid(frame, value, at);
  }

  /** {@code x = value}. */
  public static final class Assign extends Node {
    private final Place place;
    private final Node value;

    public Assign(Span span, Place place, Node value) {
      super(span);
      this.place = place;
      this.value = value;
    }

    public Place place() {
      return place;
    }

    public Node value() {
      return value;
    }

    @Override
    public UrbiObject execute(Frame frame) {
      UrbiObject assigned = ArgumentEvaluation.notVoid(frame, value, span());
      try {
        place.assign(frame, assigned);
      } catch (UrbiException e) {
        throw frame.located(e, span());
      }
      return assigned;
    }
  }
}

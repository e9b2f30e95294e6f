package org.urbi.kernel.node;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.UrbiObject;

/** The formal arguments of a strict function. */
public final class Formals {
  private final String[] names;
  private final Node[] defaults;
  private final Node[] types;
  private final int[] parameterCells;
  private final boolean variadic;
  private final boolean hasDefaults;
  private final int min;

  /**
   * @param defaults the default value of each parameter, or null
   * @param types the type that each parameter must have, or null
   * @param parameterCells the cell of each parameter, or -1
   * @param variadic whether the last one receives the remaining arguments as a list
   */
  public Formals(
      String[] names, Node[] defaults, Node[] types, int[] parameterCells, boolean variadic) {
    this.names = names;
    this.defaults = defaults;
    this.types = types;
    this.parameterCells = parameterCells;
    this.variadic = variadic;
    int required = 0;
    boolean any = false;
    for (int i = 0; i < names.length - (variadic ? 1 : 0); i++) {
      if (defaults[i] == null) {
        required = i + 1;
      } else {
        any = true;
      }
    }
    this.min = required;
    this.hasDefaults = any || Arrays.stream(types).anyMatch(t -> t != null);
  }

  int count() {
    return names.length;
  }

  int min() {
    return min;
  }

  int max() {
    return variadic ? Integer.MAX_VALUE : names.length;
  }

  /** Whether each argument is simply stored at its index. */
  boolean isSimple(int given) {
    return given == names.length && !variadic && !hasDefaults;
  }

  boolean hasDefaults() {
    return hasDefaults;
  }

  /** The defaults of those that have one. */
  List<Node> defaults() {
    return Arrays.stream(defaults).filter(Objects::nonNull).toList();
  }

  void check(Frame caller, CallSite site, int given) {
    if (given < min || given > max()) {
      throw caller.interpreter.errors().arity(site.calledName(), given, min, max());
    }
  }

  /** Creates the variables of a call: the arguments at their indices, then room for the others. */
  UrbiObject[] bind(Frame caller, CallSite site, Function called, UrbiObject[] arguments) {
    int given = arguments.length;
    check(caller, site, given);
    UrbiObject[] locals = new UrbiObject[called.layout().locals()];
    int plain = variadic ? names.length - 1 : names.length;
    System.arraycopy(arguments, 0, locals, 0, Math.min(given, plain));
    if (variadic) {
      var rest = new Elements(Math.max(0, given - plain));
      for (int i = plain; i < given; i++) {
        rest.add(arguments[i]);
      }
      locals[plain] = caller.interpreter.values().listOf(rest);
    }
    return locals;
  }

  /** Evaluates the defaults of the arguments that are missing, and checks types. */
  void bindDefaults(Frame frame) {
    for (int i = 0; i < names.length; i++) {
      if (frame.locals[i] == null && defaults[i] != null) {
        frame.locals[i] = defaults[i].execute(frame);
        if (parameterCells != null && parameterCells[i] >= 0) {
          frame.cells[parameterCells[i]] = new Cell(frame.locals[i]);
        }
      }
      if (types[i] != null) {
        TypeCheck.check(frame, names[i], i + 1, frame.locals[i], types[i].execute(frame));
      }
    }
  }
}

package org.urbi.kernel.builtin;

import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Guard;
import org.urbi.kernel.node.Profiler;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.trust.Role;

/** A function of the library, written in Java (manual, "Primitive"). */
public final class Primitive extends Code {
  private final BuiltinTable table;
  private final int index;
  private final int min;
  private final int max;

  /** Whether there are lobbies for which it does not do what it does. */
  private final boolean guarded;

  public Primitive(Shape shape, BuiltinTable table, int index) {
    super(shape);
    this.table = table;
    this.index = index;
    this.min = table.minArguments(index);
    this.max = table.maxArguments(index);
    this.guarded = table.leastRole(index) != Role.OBSERVER || table.changesTarget(index);
  }

  @Override
  public String name() {
    return table.name(index);
  }

  /** What it does, in a sentence. */
  public String doc() {
    return table.doc(index);
  }

  public int minArguments() {
    return min;
  }

  public int maxArguments() {
    return max;
  }

  @Override
  public boolean isLazy() {
    return table.isLazy(index);
  }

  @Override
  public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
    if (guarded && !caller.job().isOwner()) {
      check(caller, site, self);
    }
    int given = arguments.length;
    if (given < min || given > max) {
      throw caller.interpreter().errors().arity(site.calledName(), given, min, max);
    }
    return caller.interpreter().isProfiling()
        ? profiled(caller, site, self, arguments)
        : table.call(index, caller, site, self, arguments);
  }

  private void check(Frame caller, CallSite site, UrbiObject self) {
    Guard.checkRole(caller, site.calledName(), table.leastRole(index));
    if (table.changesTarget(index)) {
      Guard.checkChange(caller, site.calledName(), self);
    }
  }

  private UrbiObject profiled(
      Frame caller, CallSite site, UrbiObject self, UrbiObject[] arguments) {
    Profiler.Stack stack = Profiler.enter(caller.job(), site.calledName(), this);
    try {
      return table.call(index, caller, site, self, arguments);
    } finally {
      if (stack != null) {
        stack.leave();
      }
    }
  }

  /** The functions of the library are the system's, and there are too many to note it in each. */
  @Override
  public UrbiObject keeper() {
    UrbiObject keeper = super.keeper();
    return keeper == null ? world().values().object : keeper;
  }

  @Override
  public UrbiObject cloned() {
    return new Primitive(cloneShape(), table, index);
  }
}

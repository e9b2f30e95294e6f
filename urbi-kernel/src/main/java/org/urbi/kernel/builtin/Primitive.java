package org.urbi.kernel.builtin;

import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
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

  /** Whether some lobbies are not allowed to call it. */
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

  /** Its name, its arguments and the type of its result, as the documentation shows them. */
  public String signature() {
    return table.signature(index);
  }

  /** The type of the result, "void" when there is none; empty when it may be any. */
  public String result() {
    return table.result(index);
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
    PermissionCheck.checkRole(caller, site.calledName(), table.leastRole(index));
    if (table.changesTarget(index)) {
      PermissionCheck.checkChange(caller, site.calledName(), self);
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

  /**
   * All functions of the library belong to the system; storing that in each of them would waste
   * memory.
   */
  @Override
  public UrbiObject ownerLobby() {
    UrbiObject ownerLobby = super.ownerLobby();
    return ownerLobby == null ? world().values().object : ownerLobby;
  }

  @Override
  public UrbiObject cloned() {
    return new Primitive(cloneShape(), table, index);
  }
}

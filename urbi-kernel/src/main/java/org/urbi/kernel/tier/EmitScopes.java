package org.urbi.kernel.tier;

import static java.lang.constant.ConstantDescs.CD_void;

import java.lang.classfile.Label;
import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.ScopeEnd;

/**
 * Emits scopes. A scope is entered when something is about to be called that may add to its end;
 * while only compiled functions are called, it costs nothing. Only where the code hands out code
 * that others may evaluate at any time, which adds to the end as well, it is entered at once.
 */
final class EmitScopes {
  private final Emitter to;

  /** The scopes whose code is being emitted, innermost first. */
  private final Deque<Open> open = new ArrayDeque<>();

  /**
   * A scope.
   *
   * @param around the slot of what {@code enterScope} has answered, or else of {@link
   *     ScopeEnd#NOT_ENTERED}
   * @param loops how many loops are around it
   */
  private record Open(int around, int loops) {}

  EmitScopes(Emitter to) {
    this.to = to;
  }

  /** Emits a scope; its value is that of its code. */
  Value value(ScopeEnd.Scope scope) {
    Value result = to.newPair();
    to.loadVoid();
    to.code.astore(result.object());
    inside(() -> to.copy(to.lastStatement(scope.body()), result));
    return result;
  }

  /** Emits a scope whose value nobody uses. */
  void effect(ScopeEnd.Scope scope) {
    inside(() -> to.statement(scope.body()));
  }

  /** Emits a scope with which a function ends: what the scope has to do is done with the rest. */
  void last(ScopeEnd.Scope scope) {
    begin();
    to.last(scope.body());
    open.pop();
  }

  private void inside(Runnable code) {
    int around = begin();
    Label start = to.beginRange();
    code.run();
    Label end = to.code.newBoundLabel();
    open.pop();
    leave(around);
    Label over = to.code.newLabel();
    to.code.goto_(over);
    Label handler = to.code.newBoundLabel();
    leave(around);
    to.code.athrow();
    to.code.exceptionCatchAll(start, end, handler);
    to.code.labelBinding(over);
  }

  private int begin() {
    int around = to.newObject();
    to.constant(ScopeEnd.NOT_ENTERED, Names.SCOPE_END);
    to.code.astore(around);
    if (entersAtOnce()) {
      enter(around);
    }
    open.push(new Open(around, to.loops().around()));
    return around;
  }

  private boolean entersAtOnce() {
    return to.survey().handsOutCode();
  }

  /** Emits what makes sure that all scopes around have been entered. */
  void enter() {
    if (!entersAtOnce()) {
      open.descendingIterator().forEachRemaining(scope -> enter(scope.around()));
    }
  }

  private void enter(int around) {
    to.frameIfAny();
    to.code.aload(around);
    to.help("enterScope", Names.SCOPE_END, Names.FRAME, Names.SCOPE_END);
    to.code.astore(around);
  }

  private void leave(int around) {
    Label over = to.code.newLabel();
    if (to.isCounting()) {
      to.code.aload(around);
      to.constant(ScopeEnd.NOT_ENTERED, Names.SCOPE_END);
      to.code.if_acmpeq(over);
    }
    to.frameIfAny();
    to.code.aload(around);
    to.help("leaveScope", CD_void, Names.FRAME, Names.SCOPE_END);
    to.code.labelBinding(over);
  }

  /** Emits the end of the scopes that are inside of so many loops: they are about to be left. */
  void leaveAll(int loops) {
    @Nullable Open last = null;
    for (Open scope : open) {
      if (scope.loops() >= loops) {
        last = scope;
      }
    }
    if (last != null) {
      leave(last.around());
    }
  }
}

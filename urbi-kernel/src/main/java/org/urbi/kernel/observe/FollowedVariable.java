package org.urbi.kernel.observe;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.journal.LooseReference;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.variable.UrbiUVar;

/** A UVar, which is not kept alive by being followed. */
final class FollowedVariable extends FollowedSlot {
  private final Interpreter interpreter;
  private final LooseReference<UrbiUVar> variable;
  private long hook;

  FollowedVariable(VariableFeed feed, Interpreter interpreter, UrbiUVar variable, String path) {
    super(feed, path);
    this.interpreter = interpreter;
    this.variable = new LooseReference<>(interpreter.scheduler().journal(), variable);
  }

  @Nullable UrbiUVar variable() {
    return variable.get();
  }

  @Override
  @Nullable UrbiObject now() {
    UrbiUVar present = variable.get();
    return present == null ? null : present.visible().value();
  }

  @Override
  void listen(boolean on) {
    UrbiUVar present = variable.get();
    if (present == null || on == (hook != 0)) {
      return;
    }
    if (on) {
      hook = present.notifyChange(interpreter, (frame, changed, value) -> seen(value.value()));
    } else {
      present.removeChange(hook);
      hook = 0;
    }
  }

  @Override
  boolean isThere() {
    UrbiUVar present = variable.get();
    UrbiObject owner = present == null ? null : present.owner();
    return present != null
        && owner != null
        && UrbiUVar.behind(owner, owner.world().symbol(slot(present))) == present;
  }

  /** The name of the slot behind which a variable stands. */
  static String slot(UrbiUVar variable) {
    return variable.name().substring(variable.name().lastIndexOf('.') + 1);
  }
}

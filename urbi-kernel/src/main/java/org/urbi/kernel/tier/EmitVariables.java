package org.urbi.kernel.tier;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.Variables;

/** Emits declarations and assignments of plain variables. */
final class EmitVariables {
  private final Emitter to;

  EmitVariables(Emitter to) {
    this.to = to;
  }

  static boolean isPlain(Variables.Declare declaration) {
    return declaration.place().declaredLocal() >= 0 && !declaration.isTyped();
  }

  Value value(Variables.Declare declaration) {
    return assigned(declaration.place().declaredLocal(), declaration.value(), declaration);
  }

  Value value(Variables.Assign assignment) {
    return assigned(assignment.place().local(), assignment.value(), assignment);
  }

  private Value assigned(int index, @Nullable Node node, Node at) {
    Value variable = to.variable(index);
    Value value = node == null ? to.voidValue() : to.operand(node);
    if (node != null && value.hasObject()) {
      to.located(at, () -> to.notVoid(value));
    }
    if (value.variable() != index) {
      to.copy(value, variable);
    }
    to.afterStore(variable);
    return variable;
  }
}

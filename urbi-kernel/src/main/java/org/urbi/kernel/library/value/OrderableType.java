package org.urbi.kernel.library.value;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;

/** Objects with one of the operators of order (manual, "Orderable"). */
@UrbiType(
    value = "Orderable",
    doc = "Objects that can be compared for order.",
    needs = Permission.NOTHING)
final class OrderableType {
  private OrderableType() {}

  private static boolean holds(Frame caller, UrbiObject left, String operator, UrbiObject right) {
    return Truth.of(caller, caller.interpreter().send(caller, left, operator, right));
  }

  @Builtin(value = "<", doc = "Whether that > the target.")
  static boolean less(Frame caller, UrbiObject self, UrbiObject that) {
    return holds(caller, that, ">", self);
  }

  @Builtin(value = ">", doc = "Whether that < the target.")
  static boolean greater(Frame caller, UrbiObject self, UrbiObject that) {
    return holds(caller, that, "<", self);
  }

  @Builtin(value = "<=", doc = "Whether not that < the target.")
  static boolean lessOrEqual(Frame caller, UrbiObject self, UrbiObject that) {
    return !holds(caller, that, "<", self);
  }

  @Builtin(value = ">=", doc = "Whether not the target < that.")
  static boolean greaterOrEqual(Frame caller, UrbiObject self, UrbiObject that) {
    return !holds(caller, self, "<", that);
  }
}

package org.urbi.kernel.library.value;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;

/** Objects with one of the operators of equality (manual, "Comparable"). */
@UrbiType(
    value = "Comparable",
    doc = "Objects that can be compared for equality.",
    needs = Permission.NOTHING)
final class ComparableType {
  private ComparableType() {}

  @Builtin(value = "==", doc = "The negation of '!=', or identity where that is not defined.")
  static boolean equals(Frame caller, UrbiObject self, UrbiObject that) {
    UrbiObject definer = self.locate(self.world().symbol("!="));
    if (definer == null || definer == self.world().prototype("Comparable")) {
      return self == that;
    }
    return !Truth.of(caller, caller.interpreter().send(caller, self, "!=", that));
  }

  @Builtin(value = "!=", doc = "The negation of '=='.")
  static boolean differs(Frame caller, UrbiObject self, UrbiObject that) {
    return !Truth.of(caller, caller.interpreter().send(caller, self, "==", that));
  }
}

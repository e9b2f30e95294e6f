package org.urbi.kernel.library.collection;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;

/** Objects with {@code has} or {@code hasNot} (manual, "Container"). */
@UrbiType(
    value = "Container",
    doc = "Objects that other objects can be in.",
    needs = Permission.NOTHING)
final class ContainerType {
  private ContainerType() {}

  @Builtin(doc = "The negation of hasNot.")
  static boolean has(Frame caller, UrbiObject self, UrbiObject e) {
    return !Truth.of(caller, caller.interpreter().send(caller, self, "hasNot", e));
  }

  @Builtin(doc = "The negation of has.")
  static boolean hasNot(Frame caller, UrbiObject self, UrbiObject e) {
    return !Truth.of(caller, caller.interpreter().send(caller, self, "has", e));
  }
}

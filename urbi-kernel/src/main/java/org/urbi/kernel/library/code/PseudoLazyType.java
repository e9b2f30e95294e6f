package org.urbi.kernel.library.code;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.object.UrbiObject;

/** Evaluated values in the place of lazy ones (manual, "PseudoLazy"). */
@UrbiType(
    value = "PseudoLazy",
    doc = "A value that is used like one not evaluated yet.",
    needs = Permission.NOTHING)
final class PseudoLazyType {
  private PseudoLazyType() {}

  @Builtin(doc = "Holds that value.", needs = Permission.CHANGE)
  static void init(UrbiObject self, UrbiObject value) {
    OwnSlots.put(self, "value", value);
  }

  @Builtin(doc = "The value that it holds.")
  static UrbiObject eval(UrbiObject self) {
    UrbiObject value = self.lookup(self.world().symbol("value"));
    return value == null ? self.world().values().voidObject : value;
  }
}

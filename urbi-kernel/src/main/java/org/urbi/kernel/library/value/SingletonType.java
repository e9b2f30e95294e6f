package org.urbi.kernel.library.value;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.object.UrbiObject;

/** Prototypes that cannot be cloned (manual, "Singleton"). */
@UrbiType(
    value = "Singleton",
    doc = "A prototype that cannot be cloned.",
    needs = Permission.NOTHING)
final class SingletonType {
  private SingletonType() {}

  @Builtin(
      value = {"clone", "new"},
      doc = "The target.")
  static UrbiObject clone(UrbiObject self) {
    return self;
  }
}

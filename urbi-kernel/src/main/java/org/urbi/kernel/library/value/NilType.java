package org.urbi.kernel.library.value;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.object.UrbiObject;

/** The empty value (manual, "nil"). */
@UrbiType(value = "nil", protos = "Singleton", doc = "The empty value.", needs = Permission.NOTHING)
final class NilType {
  private NilType() {}

  @Builtin(doc = "Whether it is nil: true.")
  static boolean isNil(UrbiObject self) {
    return true;
  }

  @Builtin(doc = "false.")
  static boolean asBool(UrbiObject self) {
    return false;
  }

  @Builtin(
      value = {"asString", "asPrintable"},
      doc = "\"nil\".")
  static String asString(UrbiObject self) {
    return "nil";
  }
}

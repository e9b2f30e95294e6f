package org.urbi.kernel.library.value;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;

/** The prototype of {@code true} and {@code false} (manual, "Boolean"). */
@UrbiType(
    value = "Boolean",
    protos = "Singleton",
    doc = "The truth values, true and false.",
    needs = Permission.NOTHING)
final class BooleanType {
  private BooleanType() {}

  private static boolean isTrue(Frame caller, UrbiObject self) {
    return self == caller.interpreter().world().values().trueObject;
  }

  @Builtin(value = "!", doc = "The other truth value.")
  static boolean not(Frame caller, UrbiObject self) {
    return !isTrue(caller, self);
  }

  @Builtin(doc = "The target.")
  static UrbiObject asBool(UrbiObject self) {
    return self;
  }

  @Builtin(
      value = {"asString", "asPrintable"},
      doc = "\"true\" or \"false\".")
  static String asString(Frame caller, UrbiObject self) {
    Values values = caller.interpreter().world().values();
    return self == values.trueObject ? "true" : self == values.falseObject ? "false" : "Boolean";
  }
}

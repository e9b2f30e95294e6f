package org.urbi.kernel.library.value;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** No value (manual, "void"): what it lets do with itself. */
@UrbiType(
    value = "void",
    protos = {},
    doc = "No value: what cannot be read, nor passed on.",
    needs = Permission.NOTHING)
final class VoidType {
  private VoidType() {}

  @Builtin(doc = "A void that can be passed on.")
  static UrbiObject acceptVoid(Frame caller, UrbiObject self) {
    return caller.interpreter().world().values().acceptedVoid;
  }

  @Builtin(doc = "The void that cannot be passed on.")
  static void unacceptVoid(UrbiObject self) {}

  @Builtin(doc = "Neither true nor false: void cannot be looked at.")
  static UrbiObject asBool(Frame caller, UrbiObject self) {
    throw caller.interpreter().errors().unexpectedVoid();
  }

  @Builtin(doc = "Whether it is void: true.")
  static boolean isVoid(UrbiObject self) {
    return true;
  }

  @Builtin(
      value = {"asString", "asPrintable"},
      doc = "\"void\".")
  static String asString(UrbiObject self) {
    return "void";
  }
}

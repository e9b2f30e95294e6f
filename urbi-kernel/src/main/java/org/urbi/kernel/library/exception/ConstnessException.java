package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** An attempt to change a constant (manual, "Exception"). */
@UrbiType(
    value = "Exception.Constness",
    protos = {"Exception"},
    doc = "An attempt to change a constant.")
final class ConstnessException {
  private ConstnessException() {}

  @Builtin(doc = "Without arguments.")
  static void init(UrbiObject self) {}

  @Builtin(doc = "What is wrong.")
  static String asString(Frame frame, UrbiObject self) {
    return "cannot modify const slot";
  }
}

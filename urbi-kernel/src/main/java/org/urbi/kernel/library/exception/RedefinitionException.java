package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** A slot that is there already (manual, "Exception"). */
@UrbiType(
    value = "Exception.Redefinition",
    protos = {"Exception"},
    doc = "A slot that is there already.")
final class RedefinitionException {
  private RedefinitionException() {}

  @Builtin(doc = "Of the slot of that name.")
  static void init(UrbiObject self, UrbiObject name) {
    ExceptionType.set(self, "name", name);
  }

  @Builtin(doc = "The name of the slot.")
  static String asString(Frame frame, UrbiObject self) {
    return "slot redefinition: " + ExceptionType.text(frame, self, "name");
  }
}

package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** An error in a routine of the library (manual, "Exception"). */
@UrbiType(
    value = "Exception.Primitive",
    protos = {"Exception"},
    doc = "An error in a routine of the library.")
final class PrimitiveException {
  private PrimitiveException() {}

  @Builtin(doc = "Of that routine, with that message.")
  static void init(UrbiObject self, UrbiObject routine, UrbiObject message) {
    ExceptionType.set(self, "routine", routine);
    ExceptionType.set(self, "message", message);
  }

  @Builtin(doc = "The routine and the message.")
  static String asString(Frame frame, UrbiObject self) {
    return ExceptionType.text(frame, self, "routine")
        + ": "
        + ExceptionType.text(frame, self, "message");
  }
}

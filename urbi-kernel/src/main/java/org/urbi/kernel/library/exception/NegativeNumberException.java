package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** A number that should not be negative (manual, "Exception"). */
@UrbiType(
    value = "Exception.NegativeNumber",
    protos = {"Exception.BadNumber"},
    doc = "A number that should not be negative.")
final class NegativeNumberException {
  private NegativeNumberException() {}

  @Builtin(doc = "Of that routine, and the number.")
  static void init(UrbiObject self, UrbiObject routine, UrbiObject effective) {
    ExceptionType.set(self, "routine", routine);
    ExceptionType.set(self, "effective", effective);
  }

  @Builtin(doc = "The routine, and the number.")
  static String asString(Frame frame, UrbiObject self) {
    return ExceptionType.text(frame, self, "routine")
        + ": unexpected "
        + ExceptionType.text(frame, self, "effective")
        + ", expected non-negative number";
  }
}

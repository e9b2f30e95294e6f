package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** An argument that could not be used (manual, "Exception"). */
@UrbiType(
    value = "Exception.Argument",
    protos = {"Exception"},
    doc = "An argument that could not be used.")
final class ArgumentException {
  private ArgumentException() {}

  @Builtin(doc = "Of that routine, the argument at that index, for that reason.")
  static void init(UrbiObject self, UrbiObject routine, UrbiObject index, UrbiObject exception) {
    ExceptionType.set(self, "routine", routine);
    ExceptionType.set(self, "index", index);
    ExceptionType.set(self, "exception", exception);
  }

  @Builtin(doc = "The routine, the argument, and the reason.")
  static String asString(Frame frame, UrbiObject self) {
    int index = ExceptionNumbers.count(self, "index", 0);
    return ExceptionType.text(frame, self, "routine")
        + ": "
        + (index == 0 ? "this" : "argument " + index)
        + ": "
        + ExceptionType.text(frame, self, "exception");
  }
}

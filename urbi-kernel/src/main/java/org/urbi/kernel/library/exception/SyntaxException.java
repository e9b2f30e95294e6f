package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** Source text that does not parse (manual, "Exception"). */
@UrbiType(
    value = "Exception.Syntax",
    protos = {"Exception"},
    doc = "Source text that does not parse.")
final class SyntaxException {
  private SyntaxException() {}

  @Builtin(doc = "At that place, with that message, in that text.")
  static void init(UrbiObject self, UrbiObject location, UrbiObject message, UrbiObject input) {
    ExceptionType.set(self, "loc", location);
    ExceptionType.set(self, "message", message);
    ExceptionType.set(self, "input", input);
  }

  @Builtin(doc = "The place and the message.")
  static String asString(Frame frame, UrbiObject self) {
    return ExceptionType.text(frame, self, "loc")
        + ": syntax error: "
        + ExceptionType.text(frame, self, "message");
  }
}

package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** A call with a wrong number of arguments (manual, "Exception"). */
@UrbiType(
    value = "Exception.Arity",
    protos = {"Exception"},
    doc = "A call with a wrong number of arguments.")
final class ArityException {
  private ArityException() {}

  @Builtin(doc = "Of that routine, given so many arguments, with these bounds.")
  static void init(
      UrbiObject self,
      UrbiObject routine,
      UrbiObject effective,
      UrbiObject minimum,
      @Optional UrbiObject maximum) {
    ExceptionType.set(self, "routine", routine);
    ExceptionType.set(self, "effective", effective);
    ExceptionType.set(self, "minimum", minimum);
    ExceptionType.set(self, "maximum", maximum == null ? minimum : maximum);
  }

  @Builtin(doc = "The routine, how many arguments it expected, how many it was given.")
  static String asString(Frame frame, UrbiObject self) {
    return Errors.arityMessage(
        ExceptionType.text(frame, self, "routine"),
        ExceptionNumbers.count(self, "effective", 0),
        ExceptionNumbers.count(self, "minimum", 0),
        ExceptionNumbers.count(self, "maximum", Integer.MAX_VALUE));
  }
}

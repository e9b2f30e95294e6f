package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** A number that a routine cannot use (manual, "Exception"). */
@UrbiType(
    value = "Exception.BadNumber",
    protos = {"Exception"},
    doc = "A number that a routine cannot use.")
final class BadNumberException {
  private BadNumberException() {}

  @Builtin(doc = "Of that routine, with a format for the message, and the number.")
  static void init(UrbiObject self, UrbiObject routine, UrbiObject format, UrbiObject effective) {
    ExceptionType.set(self, "routine", routine);
    ExceptionType.set(self, "fmt", format);
    ExceptionType.set(self, "effective", effective);
  }

  @Builtin(doc = "The routine, and what is wrong with the number.")
  static String asString(Frame frame, UrbiObject self) {
    if (self.lookup(self.world().symbol("fmt")) == null) {
      return ExceptionType.asString(frame, self);
    }
    String routine = ExceptionType.text(frame, self, "routine");
    // An argument exception names the routine itself.
    return (routine.isEmpty() ? "" : routine + ": ")
        + ExceptionType.text(frame, self, "fmt")
            .replace("%s", ExceptionType.text(frame, self, "effective"));
  }
}

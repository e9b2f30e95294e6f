package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** A value of another type than expected (manual, "Exception"). */
@UrbiType(
    value = "Exception.Type",
    protos = {"Exception"},
    doc = "A value of another type than expected.")
final class TypeException {
  private TypeException() {}

  @Builtin(doc = "Of that value, where that type was expected.")
  static void init(UrbiObject self, UrbiObject effective, UrbiObject expected) {
    ExceptionType.set(self, "effective", effective);
    ExceptionType.set(self, "expected", expected);
  }

  @Builtin(doc = "The value, and the type that was expected.")
  static String asString(Frame frame, UrbiObject self) {
    UrbiObject effective = self.lookup(self.world().symbol("effective"));
    UrbiObject expected = self.lookup(self.world().symbol("expected"));
    String type =
        expected == null
            ? "Object"
            : frame
                .interpreter()
                .asString(frame, frame.interpreter().send(frame, expected, "type"));
    String shown = effective == null ? "" : frame.interpreter().asPrintable(frame, effective);
    String article = "AEIOUaeiou".indexOf(type.charAt(0)) >= 0 ? "an " : "a ";
    return "unexpected " + shown + ", expected " + article + type;
  }
}

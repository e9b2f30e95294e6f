package org.urbi.kernel.library.exception;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** Errors, and what they have in common (manual, "Exception"). */
@UrbiType(
    value = "Exception",
    protos = {"Object", "Traceable"},
    doc = "An error, with a message.",
    needs = Permission.NOTHING)
public final class ExceptionType {
  private ExceptionType() {}

  /** The text of a slot of an exception, as asString shows it. */
  public static String text(Frame frame, UrbiObject self, String name) {
    UrbiObject value = self.lookup(self.world().symbol(name));
    return value == null || value == self.world().values().voidObject
        ? ""
        : frame.interpreter().asString(frame, value);
  }

  @Builtin(doc = "Makes an exception with that message.", needs = Permission.CHANGE)
  static void init(UrbiObject self, @Optional @Nullable UrbiObject message) {
    if (message != null) {
      OwnSlots.put(self, "message", message);
    }
  }

  @Builtin(doc = "The message; once it has been caught, with the place where it was thrown.")
  static String asString(Frame frame, UrbiObject self) {
    UrbiObject message = self.lookup(self.world().symbol("message"));
    return placed(
        frame,
        self,
        message instanceof UrbiString text ? text.value() : text(frame, self, "message"));
  }

  /** The text of an exception, behind the place where it was thrown if that is known. */
  static String placed(Frame frame, UrbiObject self, String text) {
    return frame.interpreter().errors().tellsPlace(self)
        ? text(frame, self, "location") + ": " + text
        : text;
  }

  @Builtin(doc = "The type and the message, as the console shows it.")
  static String asPrintable(Frame frame, UrbiObject self) {
    return text(frame, self, "fullType") + " `" + frame.interpreter().asString(frame, self) + "'";
  }
}

package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.lobby.Warnings;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** An argument of the wrong type, as old programs throw it (manual, "Exception"). */
@UrbiType(
    value = "Exception.ArgumentType",
    protos = {"Exception.Type"},
    doc = "Deprecated: an argument of the wrong type.")
final class ArgumentTypeException {
  private ArgumentTypeException() {}

  @Builtin(doc = "Of that function, at that place, with that value instead of one of that type.")
  static void init(
      Frame frame,
      CallSite site,
      UrbiObject self,
      UrbiObject routine,
      UrbiObject index,
      UrbiObject effective,
      UrbiObject expected) {
    Warnings.deprecated(frame, site, "Exception.ArgumentType", null);
    OwnSlots.put(self, "routine", routine);
    OwnSlots.put(self, "index", index);
    OwnSlots.put(self, "effective", effective);
    OwnSlots.put(self, "expected", expected);
  }

  @Builtin(doc = "The function, the place, the value and the type.")
  static String asString(Frame frame, UrbiObject self) {
    return ExceptionType.text(frame, self, "routine")
        + ": argument "
        + ExceptionType.text(frame, self, "index")
        + ": "
        + TypeException.asString(frame, self);
  }
}

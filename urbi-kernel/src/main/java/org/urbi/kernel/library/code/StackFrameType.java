package org.urbi.kernel.library.code;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;

/** Calls that are going on (manual, "StackFrame"). */
@UrbiType(
    value = "StackFrame",
    doc = "A call: what was called, and where.",
    needs = Permission.NOTHING)
final class StackFrameType {
  private StackFrameType() {}

  static void fill(UrbiObject self, UrbiObject name, UrbiObject location) {
    OwnSlots.put(self, "name", name);
    OwnSlots.put(self, "location", location);
  }

  @Builtin(doc = "A call of the function of that name at that location.", needs = Permission.CHANGE)
  static void init(UrbiObject self, UrbiString name, UrbiObject location) {
    fill(self, name, location);
  }

  @Builtin(doc = "The location and the name.")
  static String asString(Frame frame, UrbiObject self) {
    if (self == self.world().prototype("StackFrame")) {
      return "StackFrame";
    }
    return frame.interpreter().asString(frame, OwnSlots.get(frame, self, "location"))
        + ": "
        + frame.interpreter().asString(frame, OwnSlots.get(frame, self, "name"));
  }
}

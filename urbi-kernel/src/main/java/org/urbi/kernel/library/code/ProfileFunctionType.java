package org.urbi.kernel.library.code;

import java.util.Locale;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** The calls of one function in a profile (manual, "Profile.Function"). */
@UrbiType(
    value = "Profile.Function",
    doc = "The calls of a function that a profile counts.",
    needs = Permission.NOTHING)
final class ProfileFunctionType {
  private ProfileFunctionType() {}

  private static double number(Frame frame, UrbiObject self, String slot) {
    return OwnSlots.get(frame, self, slot) instanceof UrbiFloat known ? known.value() : 0;
  }

  @Builtin(doc = "The name, the number of calls, the time in all and by call.")
  static String asString(Frame frame, UrbiObject self) {
    if (!self.hasLocalSlot(self.world().symbol("selfTime"))) {
      return "Function";
    }
    return String.format(
        Locale.ROOT,
        "Function('%s', %d, %.6f, %.6f)",
        frame.interpreter().asString(frame, OwnSlots.get(frame, self, "name")),
        (long) number(frame, self, "calls"),
        number(frame, self, "selfTime"),
        number(frame, self, "selfTimePer"));
  }
}

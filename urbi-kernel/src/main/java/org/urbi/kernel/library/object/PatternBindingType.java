package org.urbi.kernel.library.object;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiObject;

/** Variables of patterns (manual, "Pattern": Binding). */
@UrbiType(
    value = "Pattern.Binding",
    doc = "A part of a pattern that matches and binds any value.",
    needs = Permission.NOTHING)
final class PatternBindingType {
  private static final String NAME = "name";

  private PatternBindingType() {}

  @Builtin(doc = "Binds what it matches to that name.", needs = Permission.CHANGE)
  static UrbiObject init(Frame frame, UrbiObject self, String name) {
    OwnSlots.put(self, NAME, frame.interpreter().values().string(name));
    return self;
  }

  @Builtin(doc = "Puts a value into the bindings of a pattern; true.")
  static boolean match(
      Frame frame, CallSite site, UrbiObject self, UrbiObject pattern, UrbiObject value) {
    boolean isPattern = pattern.isA(self.world().prototype("Pattern"));
    if (!isPattern || !(bindings(frame, pattern) instanceof UrbiDictionary bindings)) {
      throw frame
          .interpreter()
          .errors()
          .argumentType(site.calledName(), 1, pattern, self.world().prototype("Pattern"));
    }
    UrbiObject name = OwnSlots.get(frame, self, NAME);
    frame.interpreter().send(frame, bindings, "[]=", name, value);
    return true;
  }

  private static UrbiObject bindings(Frame frame, UrbiObject pattern) {
    return OwnSlots.get(frame, pattern, PatternType.BINDINGS);
  }

  @Builtin(doc = "The binding as it is written in a pattern: var and its name.")
  static String asString(Frame frame, UrbiObject self) {
    return self.hasLocalSlot(self.world().symbol(NAME))
        ? "var " + frame.interpreter().asString(frame, OwnSlots.get(frame, self, NAME))
        : "Binding";
  }
}

package org.urbi.kernel.library.value;

import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.ClassNodes;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;

/** Enumeration types (manual, "Enumeration"). */
@UrbiType(
    value = "Enumeration",
    protos = {"RangeIterable", "Container"},
    doc = "A type with a finite set of values.",
    needs = Permission.NOTHING)
final class EnumerationType {
  private EnumerationType() {}

  @Builtin(
      doc = "Makes the type of that name, with values of these names.",
      needs = Permission.CHANGE)
  static void init(Frame frame, UrbiObject self, String name, UrbiList names) {
    ClassNodes.nameType(frame.interpreter(), self, name);
    OwnSlots.put(self, "name", self.world().values().string(name));
    List<UrbiObject> values = new ArrayList<>();
    for (UrbiObject each : names.elements()) {
      frame.job().checkInterrupted();
      UrbiObject value = self.cloned();
      value.addSlot(frame.interpreter().symbols().asString, each);
      values.add(value);
      Symbol symbol = self.world().symbol(frame.interpreter().asString(frame, each));
      if (self.hasLocalSlot(symbol)) {
        throw frame.interpreter().errors().redefinition(symbol.name());
      }
      self.addSlot(symbol, value);
    }
    self.addSlot(self.world().symbol("values"), frame.interpreter().values().list(values));
  }

  @Builtin(doc = "The number of values.")
  static double size(Frame frame, UrbiObject self) {
    return values(frame, self).elements().size();
  }

  private static UrbiList values(Frame frame, UrbiObject self) {
    UrbiObject values = frame.interpreter().get(frame, self, self.world().symbol("values"));
    return (UrbiList) values;
  }

  @Builtin(doc = "The list of the values.")
  static UrbiObject asList(Frame frame, UrbiObject self) {
    return values(frame, self);
  }

  @Builtin(doc = "Whether that is one of the values.")
  static boolean has(Frame frame, UrbiObject self, UrbiObject value) {
    return values(frame, self).elements().contains(value);
  }

  @Builtin(doc = "The name of the type; values have their own.")
  static String asString(Frame frame, UrbiObject self) {
    return frame.interpreter().asString(frame, OwnSlots.get(frame, self, "type"));
  }
}

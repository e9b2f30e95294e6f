package org.urbi.kernel.library;

import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.ClassNodes;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;

/** Enumeration types (manual, "Enumeration"). */
@UrbiType(value = "Enumeration", doc = "A type with a finite set of values.")
final class EnumerationType {
  private EnumerationType() {}

  @Builtin(doc = "Makes the type of that name, with values of these names.")
  static void init(Frame frame, UrbiObject self, String name, UrbiList names) {
    ClassNodes.nameType(frame.interpreter(), self, name);
    List<UrbiObject> values = new ArrayList<>();
    Symbol valueName = self.world().symbol("name");
    for (UrbiObject each : names.elements()) {
      UrbiObject value = self.cloned();
      value.addSlot(valueName, each);
      values.add(value);
      self.addSlot(self.world().symbol(frame.interpreter().asString(frame, each)), value);
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

  @Builtin(
      value = {"each"},
      doc = "Calls a function with each value, one after the other.")
  static void each(Frame frame, CallSite site, UrbiObject self, UrbiObject action) {
    for (UrbiObject value : List.copyOf(values(frame, self).elements())) {
      frame.interpreter().call(frame, site, action, self, value);
      frame.job().yield();
    }
  }

  @Builtin(doc = "The name of a value, or of the type.")
  static String asString(Frame frame, UrbiObject self) {
    UrbiObject name = self.localSlot(self.world().symbol("name"));
    return name == null
        ? frame.interpreter().asString(frame, frame.interpreter().send(frame, self, "type"))
        : frame.interpreter().asString(frame, name);
  }
}

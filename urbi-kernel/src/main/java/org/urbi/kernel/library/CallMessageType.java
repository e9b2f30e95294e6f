package org.urbi.kernel.library;

import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;

/** How a function was called (manual, "CallMessage"). */
@UrbiType(value = "CallMessage", doc = "A call: its target, its name, its arguments.")
final class CallMessageType {
  private CallMessageType() {}

  private static UrbiObject slot(Frame frame, UrbiObject self, String name) {
    return frame.interpreter().get(frame, self, self.world().symbol(name));
  }

  private static List<UrbiObject> arguments(Frame frame, UrbiObject self) {
    return slot(frame, self, "args") instanceof UrbiList list ? list.elements() : List.of();
  }

  @Builtin(doc = "The number of arguments.")
  static double argsCount(Frame frame, UrbiObject self) {
    return arguments(frame, self).size();
  }

  @Builtin(doc = "Evaluates the argument at that index; each time anew.")
  static UrbiObject evalArgAt(Frame frame, UrbiObject self, int index) {
    List<UrbiObject> arguments = arguments(frame, self);
    if (index < 0 || index >= arguments.size()) {
      throw frame.interpreter().errors().primitive("evalArgAt", "invalid index: " + index);
    }
    return frame.interpreter().send(frame, arguments.get(index), "eval");
  }

  @Builtin(doc = "Evaluates all arguments, and returns the list of their values.")
  static List<UrbiObject> evalArgs(Frame frame, UrbiObject self) {
    List<UrbiObject> values = new ArrayList<>();
    for (UrbiObject argument : arguments(frame, self)) {
      values.add(frame.interpreter().send(frame, argument, "eval"));
    }
    return values;
  }

  @Builtin(doc = "Makes the call, and returns its value.")
  static UrbiObject eval(Frame frame, CallSite site, UrbiObject self) {
    UrbiObject[] arguments = evalArgs(frame, self).toArray(UrbiObject[]::new);
    String name = frame.interpreter().asString(frame, slot(frame, self, "message"));
    return frame
        .interpreter()
        .send(frame, site, slot(frame, self, "target"), self.world().symbol(name), arguments);
  }
}

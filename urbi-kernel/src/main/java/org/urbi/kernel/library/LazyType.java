package org.urbi.kernel.library;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallMessages.Lazy;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Expressions that have not been evaluated yet (manual, "Lazy"). */
@UrbiType(value = "Lazy", doc = "An expression that is evaluated when asked for.")
final class LazyType {
  private LazyType() {}

  private static Symbol code(UrbiObject self) {
    return self.world().symbol("code");
  }

  private static Symbol cache(UrbiObject self) {
    return self.world().symbol("valueCache");
  }

  @Builtin(doc = "Evaluates that function without arguments when asked for.")
  static void init(UrbiObject self, UrbiObject function) {
    self.addSlot(code(self), function);
  }

  @Builtin(doc = "Evaluates the expression, each time anew.")
  static UrbiObject eval(Frame frame, UrbiObject self) {
    if (self instanceof Lazy lazy && lazy.code() != null) {
      return lazy.evaluate(frame);
    }
    return frame
        .interpreter()
        .call(frame, frame.interpreter().get(frame, self, code(self)), frame.self());
  }

  @Builtin(doc = "Evaluates the expression the first time, and remembers its value.")
  static UrbiObject value(Frame frame, UrbiObject self) {
    UrbiObject known = self.localSlot(cache(self));
    if (known == null) {
      known = eval(frame, self);
      self.addSlot(cache(self), known);
    }
    return known;
  }

  static UrbiObject newPrototype(World world) {
    return new Lazy(world.values().object.cloneShape(), null, null);
  }
}

package org.urbi.kernel.library.code;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.CallMessages.Lazy;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.node.TakenCode;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Expressions that have not been evaluated yet (manual, "Lazy"). */
@UrbiType(
    value = "Lazy",
    protos = {"Comparable"},
    doc = "An expression that is evaluated when asked for.",
    needs = Permission.NOTHING)
final class LazyType {
  private LazyType() {}

  private static Symbol code(UrbiObject self) {
    return self.world().symbol("code");
  }

  private static Symbol cache(UrbiObject self) {
    return self.world().symbol("valueCache");
  }

  @Builtin(
      doc = "Evaluates that function without arguments when asked for.",
      needs = Permission.CHANGE)
  static void init(Frame frame, UrbiObject self, UrbiObject function) {
    OwnSlots.put(self, "code", TakenCode.by(frame, function));
  }

  @Builtin(doc = "Evaluates the expression, each time anew.")
  static UrbiObject eval(Frame frame, UrbiObject self) {
    if (self instanceof Lazy lazy && lazy.argument() != null) {
      return lazy.argument().evaluate(frame);
    }
    UrbiObject result =
        frame
            .interpreter()
            .call(frame, frame.interpreter().get(frame, self, code(self)), frame.self());
    remember(frame, self, result);
    return result;
  }

  /** Keeps the value, unless the object is none that the caller may change. */
  private static void remember(Frame frame, UrbiObject self, UrbiObject value) {
    if (PermissionCheck.allowsChange(frame, self)) {
      OwnSlots.put(self, "valueCache", value);
    }
  }

  @Builtin(doc = "Evaluates the expression the first time, and remembers its value.")
  static UrbiObject value(Frame frame, UrbiObject self) {
    UrbiObject known = self.localSlot(cache(self));
    if (known == null) {
      known = eval(frame, self);
      remember(frame, self, known);
    }
    return known;
  }

  @Builtin(
      value = {"=="},
      doc = "Whether both are the same code, and the same values if they have been evaluated.")
  static boolean equal(Frame frame, UrbiObject self, UrbiObject other) {
    if (self == other) {
      return true;
    }
    if (!other.isA(frame.interpreter().prototypes().lazy)
        || !asString(frame, self).equals(asString(frame, other))) {
      return false;
    }
    UrbiObject mine = self.localSlot(cache(self));
    UrbiObject its = other.localSlot(cache(other));
    return mine == null || its == null
        ? mine == its
        : Truth.of(frame, frame.interpreter().send(frame, mine, "==", its));
  }

  @Builtin(doc = "The text of the code.")
  static String asString(Frame frame, UrbiObject self) {
    if (self instanceof Lazy lazy && lazy.argument() != null) {
      Node written = lazy.argument().code();
      return written.isWritten() ? CodeText.of(frame, written.span()) : "Lazy";
    }
    UrbiObject code = self.lookup(code(self));
    return code == null
        ? "Lazy"
        : frame.interpreter().asString(frame, frame.interpreter().send(frame, code, "bodyString"));
  }

  static UrbiObject newPrototype(World world) {
    return new Lazy(world.values().object.cloneShape(), null);
  }
}

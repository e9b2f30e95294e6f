package org.urbi.kernel.library.code;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;

/** Functions written in Java (manual, "Primitive"). */
@UrbiType(
    value = "Primitive",
    protos = {"Executable"},
    doc = "A function of the library written in Java.",
    needs = Permission.NOTHING)
final class PrimitiveType {
  private PrimitiveType() {}

  @Builtin(doc = "Calls the primitive: the list holds the target, then the arguments.")
  static UrbiObject apply(Frame frame, CallSite site, Code self, UrbiList arguments) {
    return CodeType.apply(frame, site, self, arguments);
  }

  @Builtin(doc = "The primitive itself.")
  static UrbiObject asPrimitive(UrbiObject self) {
    return self;
  }
}

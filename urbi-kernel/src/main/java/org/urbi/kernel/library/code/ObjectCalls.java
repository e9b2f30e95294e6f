package org.urbi.kernel.library.code;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** How objects are called (manual, "Object": callMessage). */
@UrbiTypePart(value = "Object", needs = Permission.NOTHING)
final class ObjectCalls {
  private ObjectCalls() {}

  @Builtin(doc = "Makes the call of a call message on the target.")
  static UrbiObject callMessage(Frame frame, UrbiObject self, UrbiObject msg) {
    return CallMessageType.send(frame, msg, self);
  }
}

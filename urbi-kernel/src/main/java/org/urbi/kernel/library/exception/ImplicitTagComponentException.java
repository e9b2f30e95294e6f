package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** An implicit tag under an unknown name (manual, "Exception"). */
@UrbiType(
    value = "Exception.ImplicitTagComponent",
    protos = {"Exception"},
    doc = "An implicit tag under an unknown name.")
final class ImplicitTagComponentException {
  private ImplicitTagComponentException() {}

  @Builtin(doc = "Without arguments.")
  static void init(UrbiObject self) {}

  @Builtin(doc = "What is wrong.")
  static String asString(Frame frame, UrbiObject self) {
    return "invalid component in implicit tag";
  }
}

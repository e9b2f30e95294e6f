package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** A void value where one was needed (manual, "Exception"). */
@UrbiType(
    value = "Exception.UnexpectedVoid",
    protos = {"Exception"},
    doc = "A void value where one was needed.")
final class UnexpectedVoidException {
  private UnexpectedVoidException() {}

  @Builtin(doc = "Without arguments.")
  static void init(UrbiObject self) {}

  @Builtin(doc = "What is wrong.")
  static String asString(Frame frame, UrbiObject self) {
    return "unexpected void";
  }
}

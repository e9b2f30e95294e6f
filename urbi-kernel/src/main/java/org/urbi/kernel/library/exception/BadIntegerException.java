package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** An integer that a routine cannot use (manual, "Exception"). */
@UrbiType(
    value = "Exception.BadInteger",
    protos = {"Exception.BadNumber"},
    doc = "An integer that a routine cannot use.")
final class BadIntegerException {
  private BadIntegerException() {}

  @Builtin(doc = "The routine, and what is wrong with the integer.")
  static String asString(Frame frame, UrbiObject self) {
    return BadNumberException.asString(frame, self);
  }
}

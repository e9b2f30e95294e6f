package org.urbi.kernel.library.exception;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** A pattern that did not match (manual, "Exception"). */
@UrbiType(
    value = "Exception.MatchFailure",
    protos = {"Exception"},
    doc = "A pattern that did not match.")
final class MatchFailureException {
  private MatchFailureException() {}

  @Builtin(doc = "Without arguments.")
  static void init(UrbiObject self) {}

  @Builtin(doc = "What is wrong.")
  static String asString(Frame frame, UrbiObject self) {
    return "pattern did not match";
  }
}

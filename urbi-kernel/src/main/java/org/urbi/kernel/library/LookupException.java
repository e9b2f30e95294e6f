package org.urbi.kernel.library;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** A name that was not found (manual, "Exception"). */
@UrbiType(
    value = "Exception.Lookup",
    protos = {"Exception"},
    doc = "A name that was not found.")
final class LookupException {
  private LookupException() {}

  @Builtin(doc = "Of that name, in that object.")
  static void init(UrbiObject self, UrbiObject object, UrbiObject name) {
    ExceptionType.set(self, "object", object);
    ExceptionType.set(self, "name", name);
  }

  @Builtin(doc = "The name that was not found.")
  static String asString(Frame frame, UrbiObject self) {
    String name = ExceptionType.text(frame, self, "name");
    return (name.contains("->") ? "property lookup failed: " : "lookup failed: ") + name;
  }
}

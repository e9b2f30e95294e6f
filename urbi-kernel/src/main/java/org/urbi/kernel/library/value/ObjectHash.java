package org.urbi.kernel.library.value;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiObject;

/** The hash of objects that are equal to themselves only (manual, "Object.hash"). */
@UrbiTypePart(value = "Object", needs = Permission.NOTHING)
final class ObjectHash {
  private ObjectHash() {}

  @Builtin(doc = "A Hash, another one for every object.")
  static UrbiHash hash(Frame caller, UrbiObject self) {
    return Hashing.hash(caller, self.uid());
  }
}

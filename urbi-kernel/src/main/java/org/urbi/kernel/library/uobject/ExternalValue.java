package org.urbi.kernel.library.uobject;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.object.UrbiObject;

/** Converts values for processes that are linked with the SDK of Urbi 2.7. */
@UrbiTypePart(value = "Object", needs = Permission.NOTHING)
final class ExternalValue {
  private ExternalValue() {}

  @Builtin(doc = "What travels in place of the object to remote UObjects: itself.")
  static UrbiObject uvalueSerialize(UrbiObject self) {
    return self;
  }
}

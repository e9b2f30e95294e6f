package org.urbi.kernel.library.value;

import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;

/** The values of variables of UObjects (manual, "UValue"). */
@UrbiType(
    value = "UValue",
    doc = "The value of a variable of a UObject.",
    needs = Permission.NOTHING)
final class UValueType {
  private UValueType() {}
}

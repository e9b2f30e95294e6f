package org.urbi.kernel.library.value;

import org.urbi.builtins.Need;
import org.urbi.builtins.UrbiType;

/** What variables of UObjects hold (manual, "UValue"). */
@UrbiType(value = "UValue", doc = "The value of a variable of a UObject.", needs = Need.NOTHING)
final class UValueType {
  private UValueType() {}
}

package org.urbi.kernel.library.value;

import org.urbi.builtins.Need;
import org.urbi.builtins.UrbiType;

/** Structures that travel by value (manual, "Casting simple structures"). */
@UrbiType(
    value = "UValueSerializable",
    doc = "What classes inherit from whose objects UObjects get and give by value.",
    needs = Need.NOTHING)
final class UValueSerializableType {
  private UValueSerializableType() {}
}

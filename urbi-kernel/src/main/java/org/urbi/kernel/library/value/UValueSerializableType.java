package org.urbi.kernel.library.value;

import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;

/** Structures that travel by value (manual, "Casting simple structures"). */
@UrbiType(
    value = "UValueSerializable",
    doc = "What classes inherit from whose objects UObjects get and give by value.",
    needs = Permission.NOTHING)
final class UValueSerializableType {
  private UValueSerializableType() {}
}

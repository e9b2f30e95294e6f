package org.urbi.kernel.library.value;

import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;

/** The structures that are known (manual, "Casting simple structures"). */
@UrbiType(
    value = "Serializables",
    doc = "The namespace of the classes whose objects UObjects get and give by value.",
    needs = Permission.NOTHING)
final class SerializablesType {
  private SerializablesType() {}
}

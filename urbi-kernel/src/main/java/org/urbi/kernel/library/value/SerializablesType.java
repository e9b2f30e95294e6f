package org.urbi.kernel.library.value;

import org.urbi.builtins.Need;
import org.urbi.builtins.UrbiType;

/** The structures that are known (manual, "Casting simple structures"). */
@UrbiType(
    value = "Serializables",
    doc = "The namespace of the classes whose objects UObjects get and give by value.",
    needs = Need.NOTHING)
final class SerializablesType {
  private SerializablesType() {}
}

package org.urbi.kernel.library.value;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Hashes (manual, "Hash"). */
@UrbiType(
    value = "Hash",
    doc = "What stands for a value in the search for it: equal values have equal ones.",
    needs = Permission.NOTHING)
final class HashType {
  private HashType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiHash(world.values().object.cloneShape(), 0);
  }

  @Builtin(doc = "The hash as a number: equal for equal hashes only.")
  static double asFloat(UrbiHash self) {
    return self.code();
  }

  @Builtin(
      doc = "Combines the hash of that with the target; returns the target.",
      needs = Permission.CHANGE)
  static UrbiObject combine(Frame caller, UrbiHash self, UrbiObject that) {
    self.combine(Hashing.code(caller, that));
    return self;
  }

  @Builtin(doc = "The target.")
  static UrbiObject hash(UrbiHash self) {
    return self;
  }

  @Builtin(value = "==", doc = "Whether that is the same hash.")
  static boolean equals(UrbiHash self, UrbiObject that) {
    return that instanceof UrbiHash other && self.code() == other.code();
  }
}

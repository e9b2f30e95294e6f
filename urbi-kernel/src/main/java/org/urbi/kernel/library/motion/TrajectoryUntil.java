package org.urbi.kernel.library.motion;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.object.UrbiObject;

/** Motions that end when something becomes true. */
@UrbiType(
    value = "TrajectoryGenerator.Until",
    protos = "TrajectoryGenerator",
    doc = "A motion that ends as soon as a condition holds.",
    needs = Permission.NOTHING)
public final class TrajectoryUntil {
  /** The implementation of {@code run}. */
  public static final String RUN = "function () { stopif (condition()) generator.run() }";

  private TrajectoryUntil() {}

  @Builtin(doc = "That motion, until that function returns true.", needs = Permission.CHANGE)
  static void init(UrbiObject self, UrbiObject generator, UrbiObject condition) {
    OwnSlots.put(self, "generator", generator);
    OwnSlots.put(self, "condition", condition);
  }
}

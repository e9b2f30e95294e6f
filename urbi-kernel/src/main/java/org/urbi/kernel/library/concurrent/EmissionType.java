package org.urbi.kernel.library.concurrent;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** The emission returned by {@code trigger} of events (manual, "Event"). */
@UrbiType(
    value = "EventHandler",
    doc = "An event that is being emitted.",
    needs = Permission.CHANGE)
final class EmissionType {
  private EmissionType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiEmission(world.values().object.cloneShape(), null);
  }

  @Builtin(doc = "Ends the emission.")
  static void stop(Frame frame, UrbiEmission self) {
    if (self.emission() != null) {
      self.emission().end(frame.job());
    }
  }
}

package org.urbi.kernel.library.motion;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/**
 * Motions at a given speed, whatever else happens to the variable (manual, "TrajectoryGenerator":
 * SpeedAdaptive).
 */
@UrbiType(
    value = "TrajectoryGenerator.SpeedAdaptive",
    protos = {"TrajectoryGenerator.ClosedLoop"},
    doc = "A way to the target at a speed, from wherever the variable is.")
final class SpeedAdaptiveTrajectoryType {
  private SpeedAdaptiveTrajectoryType() {}

  @Builtin(doc = "Moves a variable to a target so.")
  static void follow(
      Frame frame,
      CallSite site,
      UrbiObject self,
      UrbiObject read,
      UrbiObject write,
      UrbiFloat target,
      UrbiDictionary attributes) {
    Motion motion = new Motion(frame, site, self, read, write, target, attributes);
    motion.chase(motion.speed());
  }
}

package org.urbi.kernel.library.motion;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/**
 * Motions in a given time, whatever else happens to the variable (manual, "TrajectoryGenerator":
 * TimeAdaptive).
 */
@UrbiType(
    value = "TrajectoryGenerator.TimeAdaptive",
    protos = {"TrajectoryGenerator.ClosedLoop"},
    doc = "A way to the target in a time, from wherever the variable is.")
final class TimeAdaptiveTrajectoryType {
  private TimeAdaptiveTrajectoryType() {}

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
    motion.adapt(motion.positive("time"));
  }
}

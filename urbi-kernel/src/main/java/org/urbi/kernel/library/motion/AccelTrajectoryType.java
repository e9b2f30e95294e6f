package org.urbi.kernel.library.motion;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** Motions from rest, faster and faster (manual, "TrajectoryGenerator": Accel). */
@UrbiType(
    value = "TrajectoryGenerator.Accel",
    protos = {"TrajectoryGenerator.OpenLoop"},
    doc = "A trajectory with a fixed acceleration.")
final class AccelTrajectoryType {
  private AccelTrajectoryType() {}

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
    double from = motion.current();
    double acceleration = motion.positive("accel");
    double way = motion.target() - from;
    double sign = Math.signum(way);
    motion.along(
        Math.sqrt(2 * Math.abs(way) / acceleration), t -> from + sign * acceleration * t * t / 2);
  }
}

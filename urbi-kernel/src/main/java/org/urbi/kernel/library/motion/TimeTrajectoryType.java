package org.urbi.kernel.library.motion;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** Motions in a given time, or at a given speed (manual, "TrajectoryGenerator": Time). */
@UrbiType(
    value = "TrajectoryGenerator.Time",
    protos = {"TrajectoryGenerator.OpenLoop"},
    doc = "A straight way to the target, in a time or at a speed.")
final class TimeTrajectoryType {
  private TimeTrajectoryType() {}

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
    double way = motion.target() - from;
    double wanted = motion.has("time") ? motion.positive("time") : Math.abs(way) / motion.speed();
    double duration = motion.straight(way, wanted);
    motion.along(duration, t -> from + way * t / duration);
  }
}

package org.urbi.kernel.library.motion;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** Motions that begin and end softly (manual, "TrajectoryGenerator": Smooth). */
@UrbiType(
    value = "TrajectoryGenerator.Smooth",
    protos = {"TrajectoryGenerator.OpenLoop"},
    doc = "A sigmoid from the current value to the target.")
final class SmoothTrajectoryType {
  private SmoothTrajectoryType() {}

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
    double duration = motion.positive("smooth");
    double from = motion.current();
    double way = motion.target() - from;
    motion.along(duration, t -> from + way * (1 - Math.cos(Math.PI * t / duration)) / 2);
  }
}

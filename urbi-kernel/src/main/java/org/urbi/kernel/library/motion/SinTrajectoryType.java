package org.urbi.kernel.library.motion;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** Swings around the target, for ever (manual, "TrajectoryGenerator": Sin). */
@UrbiType(
    value = "TrajectoryGenerator.Sin",
    protos = {"TrajectoryGenerator.OpenLoop"},
    doc = "A sine, or a cosine, around the target.")
final class SinTrajectoryType {
  private SinTrajectoryType() {}

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
    boolean sine = motion.has("sin");
    double period = motion.positive(sine ? "sin" : "cos");
    double amplitude = motion.has("ampli") ? motion.number("ampli") : 1;
    double phase = motion.has("phase") ? motion.number("phase") : 0;
    double shift = sine ? phase : phase + Math.PI / 2;
    motion.along(
        Double.POSITIVE_INFINITY,
        t -> motion.target() + amplitude * Math.sin(2 * Math.PI * t / period + shift));
  }
}

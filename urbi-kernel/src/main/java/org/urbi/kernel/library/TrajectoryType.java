package org.urbi.kernel.library;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** Moves a variable to a target over time (manual, "TrajectoryGenerator"). */
@UrbiType(
    value = "TrajectoryGenerator",
    doc = "Changes a variable over time, from its initial value to a target.")
final class TrajectoryType {
  private TrajectoryType() {}

  @Builtin(
      doc =
          "Moves what one function reads and another one writes to a target, as the attributes"
              + " say, and returns when it is there.")
  static void follow(
      Frame frame,
      CallSite site,
      UrbiObject self,
      UrbiObject read,
      UrbiObject write,
      UrbiObject target,
      UrbiDictionary attributes) {
    if (frame.interpreter().call(frame, site, read, self) instanceof UrbiGroup) {
      GroupMotion.run(frame, site, self, read, write, target, attributes);
      return;
    }
    if (!(target instanceof UrbiFloat goal)) {
      throw frame
          .interpreter()
          .errors()
          .argumentType(
              "TrajectoryGenerator", 1, target, self.world().values().floatProto, "Float");
    }
    Motion motion = new Motion(frame, site, self, read, write, goal, attributes);
    UrbiObject kind = OwnSlots.get(frame, self, kind(frame, motion));
    frame
        .interpreter()
        .send(frame, site, kind, self.world().symbol("follow"), read, write, target, attributes);
  }

  /** The kind of motion that the attributes ask for. */
  private static String kind(Frame frame, Motion motion) {
    if (motion.has("sin") || motion.has("cos")) {
      return "Sin";
    }
    if (motion.has("smooth")) {
      return "Smooth";
    }
    if (motion.has("time")) {
      return motion.isAdaptive() ? "TimeAdaptive" : "Time";
    }
    if (motion.has("speed")) {
      return motion.isAdaptive() ? "SpeedAdaptive" : "Time";
    }
    if (motion.has("accel")) {
      return "Accel";
    }
    throw frame.interpreter().errors().primitive("TrajectoryGenerator", "unknown trajectory");
  }
}

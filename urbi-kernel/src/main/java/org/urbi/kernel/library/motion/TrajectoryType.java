package org.urbi.kernel.library.motion;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.object.UrbiGroup;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** Moves a variable to a target over time (manual, "TrajectoryGenerator"). */
@UrbiType(
    value = "TrajectoryGenerator",
    doc = "Changes a variable over time, from its initial value to a target.",
    needs = Permission.NOTHING)
final class TrajectoryType {
  private TrajectoryType() {}

  @Builtin(
      doc =
          "A motion to be run: the attributes, with the target as base and the functions getter and"
              + " setter.",
      needs = Permission.CHANGE)
  static void init(UrbiObject self, UrbiDictionary attributes) {
    OwnSlots.put(self, "attributes", attributes);
  }

  @Builtin(doc = "Runs the motion, and returns when it is over.")
  static void run(Frame frame, CallSite site, UrbiObject self) {
    if (!(OwnSlots.get(frame, self, "attributes") instanceof UrbiDictionary attributes)) {
      throw frame.error(site, Problem.NOTHING_TO_RUN);
    }
    UrbiObject base = required(frame, site, attributes, "base");
    if (!(base instanceof UrbiFloat target)) {
      throw Arguments.type(frame, site, 1, base, "Float");
    }
    UrbiObject getter = required(frame, site, attributes, "getter");
    UrbiObject setter = required(frame, site, attributes, "setter");
    follow(frame, site, self, getter, setter, target, attributes);
  }

  private static UrbiObject required(
      Frame frame, CallSite site, UrbiDictionary attributes, String name) {
    UrbiObject value =
        attributes
            .entries()
            .get(DictionaryKey.of(frame, frame.interpreter().values().string(name)));
    if (value == null) {
      throw frame.error(site, Problem.MISSING_ATTRIBUTE, name);
    }
    return value;
  }

  @Builtin(value = "+", doc = "The motion, and then that one.")
  static UrbiObject followedBy(Frame frame, UrbiObject self, UrbiObject next) {
    UrbiObject sequence = self.world().prototype("TrajectoryGenerator.Sequence").cloned();
    OwnSlots.put(sequence, "first", self);
    OwnSlots.put(sequence, "second", next);
    return sequence;
  }

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
          .argumentType("TrajectoryGenerator", 1, target, self.world().values().floatProto);
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
    throw frame.interpreter().errors().primitive("TrajectoryGenerator", Problem.UNKNOWN_TRAJECTORY);
  }
}

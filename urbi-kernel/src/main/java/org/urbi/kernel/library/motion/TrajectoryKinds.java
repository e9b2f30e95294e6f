package org.urbi.kernel.library.motion;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.trust.Role;

/** The kinds of trajectories (manual, "TrajectoryGenerator"), one row each. */
public final class TrajectoryKinds {
  private static final String OPEN_LOOP = "TrajectoryGenerator.OpenLoop";
  private static final String CLOSED_LOOP = "TrajectoryGenerator.ClosedLoop";

  /** The tables, which all kernels share: they need nothing of a kernel. */
  private static final List<BuiltinTable> TABLES = rows();

  private TrajectoryKinds() {}

  /** The tables of all kinds, in alphabetical order. */
  public static List<BuiltinTable> tables() {
    return TABLES;
  }

  private static List<BuiltinTable> rows() {
    return List.of(
        new Kind(
            "TrajectoryGenerator.Accel",
            OPEN_LOOP,
            "A trajectory with a fixed acceleration.",
            TrajectoryKinds::accelerate),
        new Kind(
            CLOSED_LOOP,
            "TrajectoryGenerator",
            "Trajectories that start anew from the current value all the time.",
            null),
        new Kind(
            OPEN_LOOP,
            "TrajectoryGenerator",
            "Trajectories that do not look at what else happens to the variable.",
            null),
        new Kind(
            "TrajectoryGenerator.Sin",
            OPEN_LOOP,
            "A sine, or a cosine, around the target.",
            TrajectoryKinds::swing),
        new Kind(
            "TrajectoryGenerator.Smooth",
            OPEN_LOOP,
            "A sigmoid from the current value to the target.",
            TrajectoryKinds::glide),
        new Kind(
            "TrajectoryGenerator.SpeedAdaptive",
            CLOSED_LOOP,
            "A way to the target at a speed, from wherever the variable is.",
            motion -> motion.chase(motion.positive("speed"))),
        new Kind(
            "TrajectoryGenerator.Time",
            OPEN_LOOP,
            "A straight way to the target, in a time or at a speed.",
            TrajectoryKinds::goStraight),
        new Kind(
            "TrajectoryGenerator.TimeAdaptive",
            CLOSED_LOOP,
            "A way to the target in a time, from wherever the variable is.",
            motion -> motion.adapt(motion.positive("time"))));
  }

  /** A kind of trajectory with its {@code follow}; null for kinds that are only bases of others. */
  private static final class Kind extends BuiltinTable {
    private final @Nullable Consumer<Motion> way;

    Kind(String type, String proto, String doc, @Nullable Consumer<Motion> way) {
      super(type, doc, new String[] {proto}, way == null ? new Entry[0] : new Entry[] {FOLLOW});
      this.way = way;
    }

    private static final Entry FOLLOW =
        new Entry(
            "follow",
            4,
            4,
            false,
            false,
            Role.OBSERVER,
            true,
            "(read, write, target: Float, attributes: Dictionary)",
            "void",
            "Moves what one function reads and another one writes to the target, in this way.");

    @Override
    public UrbiObject call(
        int index, Frame caller, CallSite site, UrbiObject self, UrbiObject[] arguments) {
      UrbiFloat target =
          arguments[2] instanceof UrbiFloat number
              ? number
              : Arguments.unexpected(caller, site, 3, arguments[2], "Float");
      UrbiDictionary attributes =
          arguments[3] instanceof UrbiDictionary given
              ? given
              : Arguments.unexpected(caller, site, 4, arguments[3], "Dictionary");
      var motion = new Motion(caller, site, self, arguments[0], arguments[1], target, attributes);
      requireNonNull(way, "declared only with a way").accept(motion);
      return caller.interpreter().values().voidObject;
    }
  }

  private static void accelerate(Motion motion) {
    double from = motion.current();
    double acceleration = motion.positive("accel");
    double way = motion.way(from);
    double sign = Math.signum(way);
    motion.along(
        Math.sqrt(2 * Math.abs(way) / acceleration), t -> from + sign * acceleration * t * t / 2);
  }

  private static void swing(Motion motion) {
    boolean sine = motion.has("sin");
    double period = motion.positive(sine ? "sin" : "cos");
    double amplitude = motion.has("ampli") ? motion.number("ampli") : 1;
    double phase = motion.has("phase") ? motion.number("phase") : 0;
    double shift = sine ? phase : phase + Math.PI / 2;
    motion.along(
        Double.POSITIVE_INFINITY,
        t -> motion.target() + amplitude * Math.sin(2 * Math.PI * t / period + shift));
  }

  private static void glide(Motion motion) {
    double duration = motion.positive("smooth");
    double from = motion.current();
    double way = motion.way(from);
    motion.along(duration, t -> from + way * (1 - Math.cos(Math.PI * t / duration)) / 2);
  }

  private static void goStraight(Motion motion) {
    double from = motion.current();
    double way = motion.way(from);
    double wanted =
        motion.has("time") ? motion.positive("time") : Math.abs(way) / motion.positive("speed");
    double duration = motion.straight(way, wanted);
    motion.along(duration, t -> from + way * t / duration);
  }
}

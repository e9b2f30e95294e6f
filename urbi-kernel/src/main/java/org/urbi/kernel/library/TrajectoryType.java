package org.urbi.kernel.library;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** Moves a variable to a target over time (manual, "TrajectoryGenerator"). */
@UrbiType(
    value = "TrajectoryGenerator",
    doc = "Changes a variable over time, from its initial value to a target.")
final class TrajectoryType {
  private TrajectoryType() {}

  /** The value of a variable at a time since the beginning, in seconds. */
  private interface Curve {
    double at(double seconds);
  }

  @Builtin(
      doc =
          "A motion to be run: the attributes, with the target as base and the functions getter and"
              + " setter.")
  static void init(UrbiObject self, UrbiDictionary attributes) {
    OwnSlots.put(self, "attributes", attributes);
  }

  @Builtin(doc = "Runs the motion, and returns when it is over.")
  static void run(Frame frame, CallSite site, UrbiObject self) {
    if (!(OwnSlots.get(frame, self, "attributes") instanceof UrbiDictionary attributes)) {
      throw frame.interpreter().errors().primitive(site.calledName(), "nothing to run");
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
      throw frame.interpreter().errors().primitive(site.calledName(), "missing attribute: " + name);
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
      UrbiFloat target,
      UrbiDictionary attributes) {
    new Motion(frame, site, self, read, write, target, attributes).run();
  }

  /** One motion of one variable. */
  private static final class Motion {
    private final Frame frame;
    private final CallSite site;
    private final UrbiObject self;
    private final UrbiObject read;
    private final UrbiObject write;
    private final double target;
    private final UrbiDictionary attributes;
    private final Job job;
    private final double start;

    Motion(
        Frame frame,
        CallSite site,
        UrbiObject self,
        UrbiObject read,
        UrbiObject write,
        UrbiFloat target,
        UrbiDictionary attributes) {
      this.frame = frame;
      this.site = site;
      this.self = self;
      this.read = read;
      this.write = write;
      this.target = target.value();
      this.attributes = attributes;
      this.job = frame.job();
      this.start = now();
    }

    void run() {
      if (has("sin") || has("cos")) {
        swing();
      } else if (has("smooth")) {
        double duration = positive("smooth");
        double from = current();
        along(duration, t -> from + (target - from) * (1 - Math.cos(Math.PI * t / duration)) / 2);
      } else if (has("time")) {
        if (isAdaptive()) {
          adapt(positive("time"));
        } else {
          straight(positive("time"));
        }
      } else if (has("speed")) {
        if (isAdaptive()) {
          chase(positive("speed"));
        } else {
          straight(Math.abs(target - current()) / positive("speed"));
        }
      } else if (has("accel")) {
        double from = current();
        double acceleration = positive("accel");
        double way = Math.abs(target - from);
        double sign = Math.signum(target - from);
        along(Math.sqrt(2 * way / acceleration), t -> from + sign * acceleration * t * t / 2);
      } else {
        throw frame.interpreter().errors().primitive("TrajectoryGenerator", "unknown trajectory");
      }
    }

    // ---------------------------------------------------------------- the kinds of motion

    private void straight(double duration) {
      double from = current();
      along(duration, t -> from + (target - from) * t / duration);
    }

    /** Around the target, for ever. */
    private void swing() {
      boolean sine = has("sin");
      double period = positive(sine ? "sin" : "cos");
      double amplitude = has("ampli") ? number("ampli") : 1;
      double phase = has("phase") ? number("phase") : 0;
      double shift = sine ? phase : phase + Math.PI / 2;
      along(
          Double.POSITIVE_INFINITY,
          t -> target + amplitude * Math.sin(2 * Math.PI * t / period + shift));
    }

    /** Follows a curve, whatever else happens to the variable, and ends at the target. */
    private void along(double duration, Curve curve) {
      for (double t = 0; t < duration; t = now() - start) {
        set(curve.at(t));
        pause(duration - t);
      }
      set(target);
    }

    /** Goes from wherever the variable is, so as to arrive in time. */
    private void adapt(double duration) {
      double last = 0;
      for (double t = 0; t < duration; t = now() - start) {
        if (t > last) {
          double left = duration - last;
          set(current() + (target - current()) * (t - last) / left);
          last = t;
        }
        pause(duration - t);
      }
      set(target);
    }

    /** Goes from wherever the variable is, at that speed. */
    private void chase(double speed) {
      double last = now();
      while (current() != target) {
        pause(Math.abs(target - current()) / speed);
        double step = speed * (now() - last);
        last = now();
        double way = target - current();
        set(Math.abs(way) <= step ? target : current() + Math.signum(way) * step);
      }
    }

    // ---------------------------------------------------------------- time and values

    /** The time that this code has not been frozen. */
    private double now() {
      return Durations.seconds(job.scheduler().now() - job.timeShift());
    }

    /** Waits for the period of the kernel, or less if less is left. */
    private void pause(double left) {
      UrbiObject period = frame.interpreter().send(frame, self, "period");
      double step = period instanceof UrbiFloat seconds ? seconds.value() : 0.02;
      job.sleepUntil(
          job.scheduler().now() + Math.max(1, Durations.nanoseconds(Math.min(step, left))));
    }

    private double current() {
      UrbiObject value = frame.interpreter().call(frame, site, read, self);
      if (value instanceof UrbiFloat number) {
        return number.value();
      }
      throw wrongType(0, value);
    }

    private void set(double value) {
      frame
          .interpreter()
          .call(frame, site, write, self, frame.interpreter().values().number(value));
    }

    private RuntimeException wrongType(int index, UrbiObject value) {
      return frame
          .interpreter()
          .errors()
          .argumentType(
              "TrajectoryGenerator",
              index,
              value,
              frame.interpreter().values().floatProto,
              "Float");
    }

    // ---------------------------------------------------------------- attributes

    private UrbiObject attribute(String name) {
      return attributes
          .entries()
          .get(DictionaryKey.of(frame, frame.interpreter().values().string(name)));
    }

    private boolean has(String name) {
      return attribute(name) != null;
    }

    private boolean isAdaptive() {
      return has("adaptive") && Truth.of(frame, attribute("adaptive"));
    }

    private double number(String name) {
      if (attribute(name) instanceof UrbiFloat number) {
        return number.value();
      }
      throw wrongType(1, attribute(name));
    }

    private double positive(String name) {
      double value = number(name);
      if (!(value > 0)) {
        throw frame
            .interpreter()
            .errors()
            .primitive("TrajectoryGenerator", name + " must be positive");
      }
      return value;
    }
  }
}

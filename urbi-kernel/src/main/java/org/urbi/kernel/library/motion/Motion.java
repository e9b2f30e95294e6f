package org.urbi.kernel.library.motion;

import static java.util.Objects.requireNonNullElse;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.event.Durations;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** One motion of one variable (manual, "TrajectoryGenerator"): what all the kinds share. */
final class Motion {
  /** The period of a kernel which has none, in seconds. */
  private static final double PERIOD = 0.02;

  /** The value of a variable at a time since the beginning, in seconds. */
  interface Curve {
    double at(double seconds);
  }

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

  double target() {
    return target;
  }

  /** How far it is to the target: never infinitely, since such a motion would not end. */
  double way(double from) {
    double way = target - from;
    if (Double.isInfinite(way)) {
      throw frame.interpreter().errors().primitive("TrajectoryGenerator", Problem.ENDLESS_WAY);
    }
    return way;
  }

  /** Follows a curve, whatever else happens to the variable, and ends at the target. */
  void along(double duration, Curve curve) {
    Limit limit = new Limit();
    for (double t = 0; t < duration; t = now() - start) {
      set(limit.towards(curve.at(t)));
      pause(duration - t);
    }
    finish(limit);
  }

  /** Goes from wherever the variable is, so as to arrive in time. */
  void adapt(double duration) {
    Limit limit = new Limit();
    double last = 0;
    for (double t = 0; t < duration; t = now() - start) {
      if (t > last) {
        double left = duration - last;
        set(limit.towards(current() + (target - current()) * (t - last) / left));
        last = t;
      }
      pause(duration - t);
    }
    finish(limit);
  }

  /** The target is due: goes there, as fast as is allowed. */
  private void finish(Limit limit) {
    for (double value = limit.towards(target); value != target; value = limit.towards(target)) {
      set(value);
      pause(Math.abs(target - value) / limit.speed);
    }
    set(target);
  }

  /** Goes from wherever the variable is, at that speed, until it is as near as it should be. */
  void chase(double wanted) {
    double speed = Math.min(Math.max(wanted, limit("speedmin")), fastest());
    double near = limit("delta");
    double last = now();
    while (!(Math.abs(way(current())) <= near)) {
      pause(Math.abs(target - current()) / speed);
      double step = speed * (now() - last);
      last = now();
      double way = way(current());
      // From a value that is not a number there is no way: it goes to the target at once.
      set(Math.abs(way) > step ? current() + Math.signum(way) * step : target);
    }
  }

  /** How long a straight way takes, given how long it should: not less than {@code speedmin}. */
  double straight(double way, double duration) {
    double slowest = limit("speedmin");
    return slowest > 0 ? Math.min(duration, Math.abs(way) / slowest) : duration;
  }

  /** Limits the speed of the variable to {@code speedmax}. */
  private final class Limit {
    private final double speed = fastest();
    private double value = speed < Double.POSITIVE_INFINITY ? current() : 0;
    private double last = start;

    double towards(double wanted) {
      if (speed < Double.POSITIVE_INFINITY) {
        double step = speed * (now() - last);
        last = now();
        value = Math.min(Math.max(wanted, value - step), value + step);
        return value;
      }
      return wanted;
    }
  }

  private double fastest() {
    double most = limit("speedmax");
    return most > 0 ? most : Double.POSITIVE_INFINITY;
  }

  private double limit(String name) {
    return has(name) ? Math.max(0, number(name)) : 0;
  }

  // ---------------------------------------------------------------- time and values

  /** The time that this code has not been frozen. */
  private double now() {
    return Durations.seconds(job.scheduler().now() - job.timeShift());
  }

  /** Waits for the period of the kernel, or less if less is left. */
  private void pause(double left) {
    UrbiObject period = frame.interpreter().send(frame, self, "period");
    double step =
        period instanceof UrbiFloat seconds && seconds.value() > 0 ? seconds.value() : PERIOD;
    job.sleepUntil(
        job.scheduler().now() + Math.max(1, Durations.nanoseconds(Math.min(step, left))));
  }

  double current() {
    UrbiObject value = frame.interpreter().call(frame, site, read, self);
    if (value instanceof UrbiFloat number) {
      return number.value();
    }
    throw wrongType(0, value);
  }

  private void set(double value) {
    frame.interpreter().call(frame, site, write, self, frame.interpreter().values().number(value));
  }

  private RuntimeException wrongType(int index, UrbiObject value) {
    return frame
        .interpreter()
        .errors()
        .argumentType("TrajectoryGenerator", index, value, frame.interpreter().values().floatProto);
  }

  // ---------------------------------------------------------------- attributes

  private @Nullable UrbiObject attribute(String name) {
    return attributes
        .entries()
        .get(DictionaryKey.of(frame, frame.interpreter().values().string(name)));
  }

  boolean has(String name) {
    return attribute(name) != null;
  }

  boolean isAdaptive() {
    UrbiObject adaptive = attribute("adaptive");
    return adaptive != null && Truth.of(frame, adaptive);
  }

  double number(String name) {
    UrbiObject given = attribute(name);
    if (given instanceof UrbiFloat number) {
      return number.value();
    }
    throw wrongType(1, requireNonNullElse(given, frame.interpreter().values().voidObject));
  }

  double positive(String name) {
    double value = number(name);
    if (!(value > 0)) {
      throw frame
          .interpreter()
          .errors()
          .primitive("TrajectoryGenerator", Problem.ATTRIBUTE_NOT_POSITIVE, name);
    }
    return value;
  }
}

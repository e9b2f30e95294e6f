package org.urbi.kernel.event;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;

/** Conversion of durations: seconds in urbiscript, nanoseconds in the scheduler. */
public final class Durations {
  private static final double NANOSECONDS = 1e9;

  /** The longest duration, in seconds: longer than any run, yet far from an overflow. */
  private static final double MAXIMUM = 1e9;

  private Durations() {}

  /** The value of an expression in nanoseconds; 0 when there is no expression. */
  static long nanoseconds(Frame frame, @Nullable Node expression) {
    if (expression == null) {
      return 0;
    }
    UrbiObject value = expression.execute(frame);
    if (value instanceof UrbiFloat number) {
      return nanoseconds(number.value());
    }
    var interpreter = frame.interpreter();
    throw frame.located(
        interpreter.errors().argumentType("duration", 1, value, interpreter.values().floatProto),
        expression.span());
  }

  /**
   * Converts seconds to nanoseconds, rounded to the nearest; an infinite duration becomes a very
   * long one.
   */
  public static long nanoseconds(double seconds) {
    double limited = Math.max(0, Math.min(seconds, MAXIMUM));
    return Math.round(limited * NANOSECONDS);
  }

  /** Nanoseconds in seconds. */
  public static double seconds(long nanoseconds) {
    return nanoseconds / NANOSECONDS;
  }
}

package org.urbi.sim.physics;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Vec3;

/**
 * A joint to be made. Its position is 0 as the bodies stand when it is made, and grows as the
 * second body moves along the axis, or turns about it, with respect to the first.
 *
 * @param first null for the world
 * @param anchor in the frame of the world; of no matter to a slider
 * @param axis in the frame of the world; of no matter to a fixed or a ball joint
 * @param low the smallest position, in radians or metres; -∞ for none
 * @param high the greatest one
 */
public record JointDescription(
    String name,
    Kind kind,
    @Nullable Body first,
    Body second,
    Vec3 anchor,
    Vec3 axis,
    double low,
    double high) {
  /** What a joint leaves free. */
  public enum Kind {
    /** Nothing. */
    FIXED,
    /** Turning about the axis. */
    HINGE,
    /** Moving along the axis. */
    SLIDER,
    /** Turning in any direction about the anchor. */
    BALL
  }

  public JointDescription {
    if (second == null || second.isFixed()) {
      throw new SimulationException(name + ": the second body has to be one that can move");
    }
    if (first == second) {
      throw new SimulationException(name + ": joins " + second.name() + " to itself");
    }
    if (!anchor.isFinite() || !axis.isFinite() || !(axis.length() > 0)) {
      throw new SimulationException(name + ": anchor and axis have to be finite, the axis not 0");
    }
    EngineLimits.within(anchor, 2 * EngineLimits.FARTHEST, name + ": anchor");
    axis = axis.normalized();
    if (!(low <= high)) {
      throw new SimulationException(name + ": limits: " + low + " is more than " + high);
    }
    boolean limited = low != Double.NEGATIVE_INFINITY || high != Double.POSITIVE_INFINITY;
    if (limited && (kind == Kind.FIXED || kind == Kind.BALL)) {
      throw new SimulationException(name + ": only a hinge and a slider have limits");
    }
  }

  /** Without limits. */
  public JointDescription(String name, Kind kind, Body first, Body second, Vec3 anchor, Vec3 axis) {
    this(
        name,
        kind,
        first,
        second,
        anchor,
        axis,
        Double.NEGATIVE_INFINITY,
        Double.POSITIVE_INFINITY);
  }
}

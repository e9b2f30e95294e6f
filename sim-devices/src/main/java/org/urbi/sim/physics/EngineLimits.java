package org.urbi.sim.physics;

import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Vec3;

/**
 * The limits of the numbers for an engine. Beyond them, a step could overflow, and libode ends the
 * process when that happens.
 */
public final class EngineLimits {
  /** From the origin, in metres. */
  public static final double FARTHEST = 1e6;

  /** In m/s and rad/s, and in m/s² for gravity. */
  public static final double FASTEST = 1e4;

  /** In N and N·m. */
  public static final double STRONGEST = 1e12;

  /** In kg. */
  public static final double LIGHTEST = 1e-9;

  /** In kg. */
  public static final double HEAVIEST = 1e9;

  private EngineLimits() {}

  /**
   * The number itself.
   *
   * @throws SimulationException if it is not finite, or larger than that to either side
   */
  public static double within(double number, double most, String what) {
    SimulationException.finite(number, what);
    if (Math.abs(number) > most) {
      throw new SimulationException(
          what + ": between " + -most + " and " + most + " expected, not " + number);
    }
    return number;
  }

  /**
   * The vector itself.
   *
   * @throws SimulationException if it is not finite, or if a part of it is larger than that
   */
  static Vec3 within(Vec3 vector, double most, String what) {
    if (!vector.isFinite()) {
      throw new SimulationException(what + " is not finite");
    }
    within(vector.x(), most, what);
    within(vector.y(), most, what);
    within(vector.z(), most, what);
    return vector;
  }
}

package org.urbi.sim.geometry;

import org.urbi.sim.SimulationException;

/** The size limits of objects: beyond them, mass and inertia would overflow. */
final class SizeLimits {
  private static final double LEAST = 1e-6;
  private static final double MAX = 1e6;

  private SizeLimits() {}

  /**
   * @throws SimulationException if one is not between a micrometre and 1000 km
   */
  static void check(double... lengths) {
    for (double length : lengths) {
      if (!(length >= LEAST && length <= MAX)) {
        throw new SimulationException(
            "size: between " + LEAST + " and " + MAX + " m expected, not " + length);
      }
    }
  }
}

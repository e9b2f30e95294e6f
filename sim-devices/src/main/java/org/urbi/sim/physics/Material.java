package org.urbi.sim.physics;

import org.urbi.sim.SimulationException;

/**
 * How a surface behaves.
 *
 * @param friction the coefficient of Coulomb's law; where two surfaces touch, the geometric mean of
 *     theirs holds
 * @param bounce how much of the speed is left after an impact, between 0 and 1; the larger one
 *     holds
 * @param rolling what slows down rolling and spinning, in metres; the larger one holds
 */
public record Material(double friction, double bounce, double rolling) {
  /** Below this speed of an impact, in m/s, nothing bounces. */
  public static final double SLOWEST_BOUNCE = 0.05;

  public static final Material DEFAULT = new Material(0.8, 0, 0);

  public Material {
    if (!(friction >= 0 && friction <= 100)) {
      throw new SimulationException("friction: between 0 and 100 expected, not " + friction);
    }
    if (!(bounce >= 0 && bounce <= 1)) {
      throw new SimulationException("bounce: between 0 and 1 expected, not " + bounce);
    }
    if (!(rolling >= 0 && rolling <= 1)) {
      throw new SimulationException("rolling: between 0 and 1 expected, not " + rolling);
    }
  }

  /** What holds where this touches another. */
  public Material touching(Material other) {
    if (this.equals(other)) {
      return this;
    }
    return new Material(
        Math.sqrt(friction * other.friction),
        Math.max(bounce, other.bounce),
        Math.max(rolling, other.rolling));
  }
}

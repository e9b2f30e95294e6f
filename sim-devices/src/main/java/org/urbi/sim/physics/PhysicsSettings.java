package org.urbi.sim.physics;

import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Vec3;

/**
 * The settings of a whole world.
 *
 * @param gravity in m/s²
 * @param step in seconds
 * @param solver how the forces of joints and contacts are found
 * @param iterations of the solver {@link Solver#QUICK}
 */
public record PhysicsSettings(Vec3 gravity, double step, Solver solver, int iterations) {
  /**
   * How much all joints and contacts give way (ODE's CFM). Without any, contacts that say the same
   * twice have no unique solution, and the exact solver may diverge.
   */
  public static final double SOFTNESS = 1e-7;

  /** A step of a millisecond under the gravity of the earth. */
  public static final PhysicsSettings DEFAULT =
      new PhysicsSettings(new Vec3(0, 0, -9.81), 0.001, Solver.EXACT, 20);

  public PhysicsSettings {
    if (!gravity.isFinite()) {
      throw new SimulationException("gravity: not finite: " + gravity);
    }
    EngineLimits.within(gravity, EngineLimits.FASTEST, "gravity");
    if (!(step > 0 && step <= 0.1)) {
      throw new SimulationException("step: between 0 and 0.1 s expected, not " + step);
    }
    if (iterations < 1 || iterations > 1000) {
      throw new SimulationException("iterations: between 1 and 1000 expected, not " + iterations);
    }
  }

  /** How the forces of joints and contacts are found. */
  public enum Solver {
    /** All at once: precise, and slow (cubic) where dozens of bodies touch each other. */
    EXACT,
    /** By iteration: linear, for heaps of bodies; stiff joints give way a little. */
    QUICK
  }

  public PhysicsSettings withStep(double seconds) {
    return new PhysicsSettings(gravity, seconds, solver, iterations);
  }

  public PhysicsSettings withSolver(Solver other, int times) {
    return new PhysicsSettings(gravity, step, other, times);
  }
}

package org.urbi.sim.physics;

import static org.junit.jupiter.api.Assumptions.abort;

import org.urbi.sim.SimulationException;
import org.urbi.sim.physics.ode.NativeOde;
import org.urbi.sim.physics.ode4j.JavaOde;

/** The engines that tests run on. Tests on the native one are skipped where it is missing. */
public enum TestedEngine {
  ODE,
  ODE4J;

  public PhysicsEngine engine() {
    if (this == ODE4J) {
      return new JavaOde();
    }
    try {
      return new NativeOde();
    } catch (SimulationException e) {
      return abort("skipped: " + e.getMessage());
    }
  }

  /** A world with a floor. */
  PhysicsWorld world(PhysicsSettings settings) {
    return new PhysicsWorld(engine(), settings);
  }
}

package org.urbi.sim.physics;

/** An engine: what makes {@link Dynamics}. */
public interface PhysicsEngine {
  /** How a world file names it. */
  String name();

  /** Name, version and precision, for people. */
  String description();

  /** An empty world of this engine. */
  Dynamics createDynamics(PhysicsSettings settings);
}

package org.urbi.sim.physics.ode;

import org.urbi.sim.SimulationException;
import org.urbi.sim.physics.Dynamics;
import org.urbi.sim.physics.PhysicsEngine;
import org.urbi.sim.physics.PhysicsSettings;

/** The Open Dynamics Engine, where a libode of double precision is installed. */
public final class NativeOde implements PhysicsEngine {
  /**
   * @throws SimulationException if there is no libode, or none that can be used
   */
  public NativeOde() {
    OdeLibrary.require();
  }

  @Override
  public String name() {
    return "ode";
  }

  @Override
  public String description() {
    return "Open Dynamics Engine, native (" + OdeLibrary.dGetConfiguration().trim() + ")";
  }

  @Override
  public Dynamics createDynamics(PhysicsSettings settings) {
    OdeLibrary.require();
    return new NativeDynamics(settings);
  }
}

package org.urbi.sim.physics.ode4j;

import org.ode4j.ode.OdeHelper;
import org.urbi.sim.physics.Dynamics;
import org.urbi.sim.physics.PhysicsEngine;
import org.urbi.sim.physics.PhysicsSettings;

/** ode4j. */
public final class JavaOde implements PhysicsEngine {
  public JavaOde() {
    OdeHelper.initODE2(0);
  }

  @Override
  public String name() {
    return "ode4j";
  }

  @Override
  public String description() {
    return "ode4j " + OdeHelper.getVersion() + " (Java, double precision)";
  }

  @Override
  public Dynamics createDynamics(PhysicsSettings settings) {
    return new JavaDynamics(settings);
  }
}

package org.urbi.sim.physics.ode4j;

import java.util.Arrays;
import org.ode4j.ode.OdeHelper;
import org.ode4j.ode.internal.ErrorHandler;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.urbi.sim.physics.Dynamics;
import org.urbi.sim.physics.PhysicsEngine;
import org.urbi.sim.physics.PhysicsSettings;

/** ode4j. */
public final class JavaOde implements PhysicsEngine {
  /** {@code urbi --debug DEBUG} shows what it is told. */
  private static final Logger LOG = LoggerFactory.getLogger("urbi.sim.ode4j");

  public JavaOde() {
    OdeHelper.initODE2(0);
    ErrorHandler.dSetMessageHandler(JavaOde::message);
  }

  /**
   * Notes what the solver says of contacts that say the same thing twice. It goes on, and who runs
   * the simulation can do nothing about it: the library's own handler would write it between what
   * is typed. The arguments stay beside the format, which is one of C.
   */
  private static void message(int number, String format, Object... arguments) {
    if (LOG.isDebugEnabled()) {
      LOG.debug("message {}: {} {}", number, format, Arrays.toString(arguments));
    }
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

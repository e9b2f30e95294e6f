package org.urbi.sim.device;

import org.urbi.sim.world.Drive;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UStart;
import urbi.UVar;

/**
 * A motor that turns at a speed (manual, interface RotationalSpeedMotor): {@code val} in rad/s. Its
 * {@code angle}, in radians, and {@code turn} tell how far it has turned.
 */
@UStart
public final class SimWheel extends SimMotor {
  private final UVar angle = new UVar();

  public SimWheel(String name) {
    super(name);
  }

  @Override
  void requireFitting(Drive found) {
    if (found.control() != Drive.Control.SPEED) {
      throw wrongControl("SimServo");
    }
  }

  @Override
  void bind(SimulatedWorld world, String deviceName) {
    super.bind(world, deviceName);
    UBindVar(angle, "angle");
    val().rangemin.setValue(-drive().maxSpeed());
    val().rangemax.setValue(drive().maxSpeed());
    UNotifyAccess(angle, "refresh");
  }

  @Override
  void updateSensors() {
    super.updateSensors();
    angle.setValue(drive().joint().position());
  }
}

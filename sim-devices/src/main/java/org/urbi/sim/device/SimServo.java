package org.urbi.sim.device;

import org.urbi.sim.SimulationException;
import org.urbi.sim.world.Drive;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UStart;
import urbi.UVar;

/**
 * A motor that goes to a position (manual, interface RotationalMotor, and "Writing a Servomotor
 * Device"): {@code val} in radians, or in metres for a slider. {@code P}, {@code I}, {@code D} are
 * the gains of its controller, {@code speed} is its greatest speed.
 */
@UStart
public final class SimServo extends SimMotor {
  private final UVar p = new UVar();
  private final UVar i = new UVar();
  private final UVar d = new UVar();
  private final UVar speed = new UVar();

  public SimServo(String name) {
    super(name);
  }

  @Override
  void requireFitting(Drive found) {
    if (found.control() != Drive.Control.POSITION) {
      throw wrongControl("SimWheel");
    }
  }

  @Override
  void bind(SimulatedWorld world, String deviceName) {
    super.bind(world, deviceName);
    UBindVars(p, "P", i, "I", d, "D", speed, "speed");
    p.setValue(drive().p());
    i.setValue(drive().i());
    d.setValue(drive().d());
    speed.setValue(drive().maxSpeed());
    if (Double.isFinite(drive().joint().low())) {
      val().rangemin.setValue(drive().joint().low());
    }
    if (Double.isFinite(drive().joint().high())) {
      val().rangemax.setValue(drive().joint().high());
    }
    for (UVar gain : new UVar[] {p, i, d}) {
      UNotifyChange(gain, "gainsChanged");
    }
    UNotifyChange(speed, "speedChanged");
    UBindFunction("setPID");
  }

  /** Sets all three gains. */
  public void setPID(double newP, double newI, double newD) {
    drive().setGains(newP, newI, newD);
    p.setValue(newP);
    i.setValue(newI);
    d.setValue(newD);
  }

  /** Another gain. */
  public void gainsChanged() {
    catchUp();
    try {
      drive().setGains(p.doubleValue(), i.doubleValue(), d.doubleValue());
    } catch (SimulationException e) {
      setPID(drive().p(), drive().i(), drive().d());
      throw e;
    }
  }

  /** Another greatest speed. */
  public void speedChanged() {
    catchUp();
    try {
      drive().setMaxSpeed(speed.doubleValue());
    } catch (SimulationException e) {
      speed.setValue(drive().maxSpeed());
      throw e;
    }
  }
}

package org.urbi.sim.device;

import java.util.function.DoubleSupplier;
import org.urbi.sim.world.Mount;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UStart;

/** Measures how fast it turns, in rad/s (manual, interface GyroSensor). */
@UStart
public final class SimGyrometer extends SimSensor {
  public SimGyrometer(String name) {
    super(name);
  }

  @Override
  DoubleSupplier measure(SimulatedWorld world, String deviceName) {
    Mount.Gyrometer sensor = world.mount(Mount.Gyrometer.class, deviceName);
    return () -> world.angularVelocity(sensor);
  }
}

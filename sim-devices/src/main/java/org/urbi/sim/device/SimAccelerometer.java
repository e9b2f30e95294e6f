package org.urbi.sim.device;

import java.util.function.DoubleSupplier;
import org.urbi.sim.world.Mount;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UStart;

/** Measures an acceleration in m/s² (manual, interface AccelerationSensor). */
@UStart
public final class SimAccelerometer extends SimSensor {
  public SimAccelerometer(String name) {
    super(name);
  }

  @Override
  DoubleSupplier measure(SimulatedWorld world, String deviceName) {
    Mount.Accelerometer sensor = world.mount(Mount.Accelerometer.class, deviceName);
    return () -> world.acceleration(sensor);
  }
}

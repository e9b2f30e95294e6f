package org.urbi.sim.device;

import java.util.function.DoubleSupplier;
import org.urbi.sim.world.Mount;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UStart;

/** Measures a distance in metres (manual, interface DistanceSensor). */
@UStart
public final class SimDistanceSensor extends SimSensor {
  public SimDistanceSensor(String name) {
    super(name);
  }

  @Override
  DoubleSupplier measure(SimulatedWorld world, String deviceName) {
    Mount.DistanceSensor sensor = world.mount(Mount.DistanceSensor.class, deviceName);
    return () -> world.distance(sensor);
  }
}

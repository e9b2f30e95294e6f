package org.urbi.sim.device;

import java.util.function.DoubleSupplier;
import org.urbi.sim.world.Mount;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UStart;

/** 1 while it touches something, otherwise 0 (manual, interface TouchSensor). */
@UStart
public final class SimTouchSensor extends SimSensor {
  public SimTouchSensor(String name) {
    super(name);
  }

  @Override
  DoubleSupplier measure(SimulatedWorld world, String deviceName) {
    Mount.Bumper sensor = world.mount(Mount.Bumper.class, deviceName);
    return () -> world.touches(sensor) ? 1 : 0;
  }
}

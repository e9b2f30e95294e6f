package org.urbi.sim.device;

import static org.urbi.sim.SimulationException.ready;

import java.util.function.DoubleSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UVar;

/** A sensor of one number, {@code val} (manual, interface Sensor). */
abstract class SimSensor extends SimDevice {
  private final UVar val = new UVar();
  private @Nullable DoubleSupplier measure;

  SimSensor(String name) {
    super(name);
  }

  @Override
  final void bind(SimulatedWorld world, String deviceName) {
    measure = measure(world, deviceName);
    UBindVar(val, "val");
    UNotifyAccess(val, "refresh");
  }

  /** How the device of that name measures. */
  abstract DoubleSupplier measure(SimulatedWorld world, String deviceName);

  @Override
  final void updateSensors() {
    val.setValue(ready(measure).getAsDouble());
  }
}

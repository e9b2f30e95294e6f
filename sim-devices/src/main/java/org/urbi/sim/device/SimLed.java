package org.urbi.sim.device;

import static org.urbi.sim.SimulationException.ready;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.render.Colour;
import org.urbi.sim.world.Mount;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UStart;
import urbi.UVar;

/**
 * A lamp (manual, interface RGBLed): {@code val} is its intensity, {@code r}, {@code g} and {@code
 * b} are those of its colours, all between 0 and 1.
 */
@UStart
public final class SimLed extends SimDevice {
  private final UVar val = new UVar();
  private final UVar r = new UVar();
  private final UVar g = new UVar();
  private final UVar b = new UVar();
  private Mount.@Nullable Led led;

  public SimLed(String name) {
    super(name);
  }

  @Override
  void bind(SimulatedWorld world, String deviceName) {
    led = world.mount(Mount.Led.class, deviceName);
    UBindVars(val, "val", r, "r", g, "g", b, "b");
    val.setValue(0);
    for (UVar colour : new UVar[] {r, g, b}) {
      colour.setValue(1);
    }
    for (UVar each : new UVar[] {val, r, g, b}) {
      each.rangemin.setValue(0);
      each.rangemax.setValue(1);
      UNotifyChange(each, "shine");
    }
  }

  /** Shines as the slots say. */
  public void shine() {
    double strength = SimulationException.finite(val.doubleValue(), "led: val");
    Colour colour = new Colour(r.doubleValue(), g.doubleValue(), b.doubleValue());
    SimulationException.finite(colour.red() + colour.green() + colour.blue(), "led: colour");
    world().light(ready(led), strength > 0 ? colour : colour.times(0.2), strength);
  }

  @Override
  void updateSensors() {
    // It senses nothing.
  }
}

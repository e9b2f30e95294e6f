package org.urbi.sim.device;

import static org.urbi.sim.SimulationException.ready;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UObject;

/**
 * A device of a simulated world: {@code new(WORLD, NAME)}, with the names of the world's UObject
 * and of the device in the world file.
 */
abstract class SimDevice extends UObject implements AutoCloseable {
  private @Nullable SimWorld simulation;

  SimDevice(String name) {
    super(name);
    UBindFunction("init");
  }

  /**
   * Joins a world.
   *
   * @throws org.urbi.sim.SimulationException if there is no such world or no such device in it
   */
  public final void init(String worldName, String deviceName) {
    SimWorld found = SimWorld.named(this, worldName);
    bind(found.world(), deviceName);
    simulation = found;
    found.add(this);
    updateSensors();
  }

  /** Finds the device, and binds what urbiscript sees of it. */
  abstract void bind(SimulatedWorld world, String deviceName);

  /** Writes what the device senses now. */
  abstract void updateSensors();

  /** The world that it has joined; null before. */
  final @Nullable SimWorld simulation() {
    return simulation;
  }

  final SimulatedWorld world() {
    return ready(simulation).world();
  }

  /** Somebody wants to read it: has time go on to now. */
  public final void refresh() {
    if (simulation != null) {
      simulation.advance();
      updateSensors();
    }
  }

  /** Has time go on to now, before a command takes effect. */
  final void catchUp() {
    if (simulation != null) {
      simulation.advance();
    }
  }

  @Override
  public void close() {
    if (simulation != null) {
      simulation.remove(this);
    }
  }
}

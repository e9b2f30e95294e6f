package org.urbi.sim.world;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.physics.PhysicsEngine;
import org.urbi.sim.physics.ode.NativeOde;
import org.urbi.sim.physics.ode4j.JavaOde;

/** Chooses the physics engine. */
public final class PhysicsEngines {
  /** The native one if there is one, otherwise ode4j. */
  public static final String ANY = "auto";

  private PhysicsEngines() {}

  /**
   * @param name {@code auto}, {@code ode} or {@code ode4j}
   * @throws SimulationException if there is none of that name, or if libode is asked for and
   *     missing
   */
  public static PhysicsEngine named(String name) {
    return switch (name) {
      case "ode" -> new NativeOde();
      case "ode4j" -> new JavaOde();
      case ANY -> best();
      default ->
          throw new SimulationException(
              "unknown engine '" + name + "'; there are auto, ode and ode4j");
    };
  }

  private static PhysicsEngine best() {
    try {
      return new NativeOde();
    } catch (SimulationException e) {
      return new JavaOde();
    }
  }

  /** Why the native engine is not used, or null if it can be. */
  public static @Nullable String whyNotNative() {
    try {
      new NativeOde();
      return null;
    } catch (SimulationException e) {
      return e.getMessage();
    }
  }
}

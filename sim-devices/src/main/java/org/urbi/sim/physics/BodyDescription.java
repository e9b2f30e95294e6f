package org.urbi.sim.physics;

import java.util.List;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Shape;

/**
 * A rigid body to be made.
 *
 * @param pose of its frame, to which those of its parts are relative
 * @param mass in kg; 0 for what never moves
 */
public record BodyDescription(String name, Pose pose, double mass, List<Part> parts) {
  /** A shape of which a body consists. */
  public record Part(Shape shape, Pose pose, Material material) {
    public Part(Shape shape) {
      this(shape, Pose.ORIGIN, Material.DEFAULT);
    }
  }

  public BodyDescription {
    parts = List.copyOf(parts);
    if (!pose.isFinite()) {
      throw new SimulationException(name + ": the place is not finite");
    }
    EngineLimits.within(pose.position(), EngineLimits.FARTHEST, name + ": the place");
    if (!(mass >= 0) || Double.isInfinite(mass)) {
      throw new SimulationException(name + ": mass: 0 or more expected, not " + mass);
    }
    if (mass > 0 && (mass < EngineLimits.LIGHTEST || mass > EngineLimits.HEAVIEST)) {
      throw new SimulationException(
          name
              + ": mass: between "
              + EngineLimits.LIGHTEST
              + " and "
              + EngineLimits.HEAVIEST
              + " kg expected, not "
              + mass);
    }
    for (Part part : parts) {
      EngineLimits.within(
          part.pose().position(), EngineLimits.FARTHEST, name + ": the place of a part");
    }
    if (mass > 0 && parts.isEmpty()) {
      throw new SimulationException(name + ": has a mass, but no shape");
    }
    if (mass > 0 && parts.stream().anyMatch(p -> p.shape() instanceof Shape.Plane)) {
      throw new SimulationException(name + ": a plane has no mass: it cannot move");
    }
  }

  /** One of a single shape. */
  public static BodyDescription of(
      String name, Pose pose, double mass, Shape shape, Material material) {
    return new BodyDescription(name, pose, mass, List.of(new Part(shape, Pose.ORIGIN, material)));
  }

  /** Whether it stays where it is, whatever happens. */
  public boolean fixed() {
    return mass == 0;
  }
}

package org.urbi.sim.world;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.Body;
import org.urbi.sim.render.Lens;

/** A device as a world file mounts it on a body. */
public sealed interface Mount {
  String name();

  /** What carries it; null for the world. */
  @Nullable Body body();

  /** Where it is on that. */
  Pose pose();

  /** Where it is in the world. */
  default Pose worldPose() {
    Body carrier = body();
    return carrier == null ? pose() : carrier.pose().apply(pose());
  }

  /** A camera, which looks along its x axis. */
  record Camera(String name, @Nullable Body body, Pose pose, Lens lens) implements Mount {}

  /**
   * Measures along its x axis.
   *
   * @param nearest what is nearer than that is measured as if it were there, in metres
   */
  record DistanceSensor(String name, Body body, Pose pose, double nearest, double farthest)
      implements Mount {}

  /**
   * Feels whether a part of its body touches something.
   *
   * @param part -1 for any
   */
  record Bumper(String name, Body body, int part) implements Mount {
    @Override
    public Pose pose() {
      return Pose.ORIGIN;
    }
  }

  /** Measures along one of its axes. */
  record Accelerometer(String name, Body body, Pose pose, Vec3 axis) implements Mount {}

  /** Measures about one of its axes. */
  record Gyrometer(String name, Body body, Pose pose, Vec3 axis) implements Mount {}

  /** A part of its body that can shine. */
  record Led(String name, Body body, int part) implements Mount {
    @Override
    public Pose pose() {
      return body.parts().get(part).pose();
    }
  }
}

package org.urbi.sim.render;

import org.urbi.sim.geometry.Vec3;

/** A light of a scene. There are no shadows. */
public sealed interface Light {
  /** Its strength in each colour. */
  Colour colour();

  /** From far away: the same everywhere. */
  record Sun(Vec3 direction, Colour colour) implements Light {
    public Sun {
      direction = direction.normalized();
    }
  }

  /** From a point, in all directions; it does not get weaker with distance. */
  record Lamp(Vec3 place, Colour colour) implements Light {}
}

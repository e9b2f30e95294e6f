package org.urbi.sim.render;

import java.util.List;

/**
 * The visible objects and lights at one moment.
 *
 * @param ambient the light that comes from everywhere, from 0 to 1
 */
public record Scene(
    List<SceneObject> things, List<Light> lights, double ambient, Colour background) {
  public Scene {
    things = List.copyOf(things);
    lights = List.copyOf(lights);
  }
}

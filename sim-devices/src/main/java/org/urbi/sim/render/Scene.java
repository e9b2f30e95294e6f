package org.urbi.sim.render;

import java.util.List;

/**
 * What there is to be seen, at a moment.
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

package org.urbi.sim.render;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.urbi.sim.geometry.Pose;

/**
 * Draws scenes: it first finds the nearest object in each pixel, then its colour. It reuses its
 * buffers for the next picture. One thread at a time uses it.
 */
public final class Renderer {
  private double[] depths = {};
  private int[] numbers = {};

  /**
   * What a camera sees.
   *
   * @param camera where it is: it looks along its x axis
   * @return red, green and blue of each pixel, row by row from the upper left one
   */
  public byte[] render(Scene scene, Pose camera, Lens lens) {
    int pixels = lens.width() * lens.height();
    if (depths.length != pixels) {
      depths = new double[pixels];
      numbers = new int[pixels];
    }
    Arrays.fill(depths, lens.far());
    Arrays.fill(numbers, -1);
    List<ProjectedObject> drawn = new ArrayList<>(scene.things().size());
    for (SceneObject thing : scene.things()) {
      ProjectedObject next = new ProjectedObject(thing, camera, lens, scene.lights());
      next.drawDepth(drawn.size(), lens, depths, numbers);
      drawn.add(next);
    }
    byte[] rgb = new byte[3 * pixels];
    byte[] background = {
      ProjectedObject.level(scene.background().red()),
      ProjectedObject.level(scene.background().green()),
      ProjectedObject.level(scene.background().blue())
    };
    for (int row = 0, at = 0; row < lens.height(); row++) {
      for (int column = 0; column < lens.width(); column++, at++) {
        if (numbers[at] < 0) {
          System.arraycopy(background, 0, rgb, 3 * at, 3);
        } else {
          drawn.get(numbers[at]).shade(column, row, depths[at], scene.ambient(), rgb, 3 * at);
        }
      }
    }
    return rgb;
  }
}

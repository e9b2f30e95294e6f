package org.urbi.sim.render;

import org.urbi.sim.SimulationException;

/**
 * How a camera projects. It looks along its x axis, its z axis is the image's upwards.
 *
 * @param width in pixels
 * @param height in pixels
 * @param xfov the angle of view from left to right, in radians
 * @param near what is nearer than that is not seen, in metres along the x axis
 * @param far what is farther than that is not seen
 */
public record Lens(int width, int height, double xfov, double near, double far) {
  private static final int MAX_SIZE = 4096;

  public Lens {
    if (width < 1 || width > MAX_SIZE || height < 1 || height > MAX_SIZE) {
      throw new SimulationException(
          "size: between 1 and " + MAX_SIZE + " pixels expected, not " + width + "x" + height);
    }
    if (!(xfov > 0.01 && xfov < 3.1)) {
      throw new SimulationException("xfov: between 0.01 and 3.1 rad expected, not " + xfov);
    }
    if (!(near > 0 && near < far)) {
      throw new SimulationException(
          "near and far: 0 < near < far expected, not " + near + ", " + far);
    }
  }

  /** The distance of the image plane, in pixels. */
  public double focalLength() {
    return width / 2.0 / StrictMath.tan(xfov / 2);
  }

  /** The angle of view from top to bottom, in radians. */
  public double yfov() {
    return 2 * StrictMath.atan(height / 2.0 / focalLength());
  }

  public Lens resized(int newWidth, int newHeight) {
    return new Lens(newWidth, newHeight, xfov, near, far);
  }
}

package org.urbi.sim.render;

import java.util.List;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Vec3;

/** An object as one camera sees it: the pixels that it may cover, its distance, its lighting. */
final class ProjectedObject {
  private final Appearance appearance;
  private final RayShape solid;

  /** The direction of the pixel in column 0 and row 0, and what a column and a row add to it. */
  private final Vec3 corner;

  private final Vec3 right;
  private final Vec3 down;

  /** Columns and rows, the last ones not included. */
  final int left;

  final int top;
  final int end;
  final int bottom;

  /** For each light: a direction against it or, of a lamp, its place; then its colour. */
  private final double[] lights;

  private final boolean[] lamps;

  ProjectedObject(SceneObject thing, Pose camera, Lens lens, List<Light> sceneLights) {
    appearance = thing.appearance();
    Pose fromCamera = camera.inverse().apply(thing.pose());
    Pose toShape = fromCamera.inverse();
    solid = RayShape.of(thing.shape(), toShape.position());
    double pixel = 1 / lens.focalLength();
    Rotation turn = toShape.rotation();
    double halfWidth = (lens.width() - 1) / 2.0;
    double halfHeight = (lens.height() - 1) / 2.0;
    corner = turn.apply(new Vec3(1, halfWidth * pixel, halfHeight * pixel));
    right = turn.apply(new Vec3(0, -pixel, 0));
    down = turn.apply(new Vec3(0, 0, -pixel));
    int[] covered = covered(fromCamera, lens);
    left = covered[0];
    top = covered[1];
    end = covered[2];
    bottom = covered[3];

    Pose worldToShape = thing.pose().inverse();
    lights = new double[6 * sceneLights.size()];
    lamps = new boolean[sceneLights.size()];
    for (int i = 0; i < sceneLights.size(); i++) {
      Light light = sceneLights.get(i);
      lamps[i] = light instanceof Light.Lamp;
      Vec3 v =
          switch (light) {
            case Light.Sun sun -> worldToShape.rotation().apply(sun.direction().times(-1));
            case Light.Lamp lamp -> worldToShape.apply(lamp.place());
          };
      Colour colour = light.colour();
      double[] numbers = {v.x(), v.y(), v.z(), colour.red(), colour.green(), colour.blue()};
      System.arraycopy(numbers, 0, lights, 6 * i, 6);
    }
  }

  /** The pixels that the box around the shape covers, as far as it is before the camera. */
  private int[] covered(Pose fromCamera, Lens lens) {
    Vec3 half = solid.halfExtent();
    if (half == null) {
      return new int[] {0, 0, lens.width(), lens.height()};
    }
    Vec3[] corners = new Vec3[8];
    for (int i = 0; i < corners.length; i++) {
      Vec3 sign = new Vec3((i & 1) * 2 - 1, (i & 2) - 1, (i >> 1 & 2) - 1);
      corners[i] =
          fromCamera.apply(new Vec3(half.x() * sign.x(), half.y() * sign.y(), half.z() * sign.z()));
    }
    double[] bounds = {
      Double.POSITIVE_INFINITY,
      Double.POSITIVE_INFINITY,
      Double.NEGATIVE_INFINITY,
      Double.NEGATIVE_INFINITY
    };
    for (int i = 0; i < corners.length; i++) {
      Vec3 corner = corners[i];
      if (corner.x() >= lens.near()) {
        widen(bounds, corner, lens);
        continue;
      }
      for (int axis = 1; axis < corners.length; axis <<= 1) {
        Vec3 neighbour = corners[i ^ axis];
        if (neighbour.x() >= lens.near()) {
          // Where the edge between them goes through the plane that is nearest to the camera.
          double share = (lens.near() - corner.x()) / (neighbour.x() - corner.x());
          Vec3 point = corner.plus(neighbour.minus(corner).times(share));
          widen(bounds, new Vec3(lens.near(), point.y(), point.z()), lens);
        }
      }
    }
    return new int[] {
      (int) Math.clamp(Math.floor(bounds[0]), 0.0, lens.width()),
      (int) Math.clamp(Math.floor(bounds[1]), 0.0, lens.height()),
      (int) Math.clamp(Math.ceil(bounds[2]) + 1, 0.0, lens.width()),
      (int) Math.clamp(Math.ceil(bounds[3]) + 1, 0.0, lens.height())
    };
  }

  /** Has bounds (left, top, right, bottom) contain the pixel where a point is seen. */
  private static void widen(double[] bounds, Vec3 point, Lens lens) {
    double x = lens.width() / 2.0 - point.y() / point.x() * lens.focalLength();
    double y = lens.height() / 2.0 - point.z() / point.x() * lens.focalLength();
    bounds[0] = Math.min(bounds[0], x);
    bounds[1] = Math.min(bounds[1], y);
    bounds[2] = Math.max(bounds[2], x);
    bounds[3] = Math.max(bounds[3], y);
  }

  /** Enters itself where it is nearer than what has been drawn before. */
  void drawDepth(int number, Lens lens, double[] depths, int[] numbers) {
    for (int row = top; row < bottom; row++) {
      double dx = corner.x() + row * down.x();
      double dy = corner.y() + row * down.y();
      double dz = corner.z() + row * down.z();
      int at = row * lens.width();
      for (int column = left; column < end; column++) {
        double depth =
            solid.intersect(
                dx + column * right.x(), dy + column * right.y(), dz + column * right.z());
        if (depth < depths[at + column] && depth >= lens.near()) {
          depths[at + column] = depth;
          numbers[at + column] = number;
        }
      }
    }
  }

  /** Colours a pixel. */
  void shade(int column, int row, double depth, double ambient, byte[] rgb, int at) {
    double dx = corner.x() + row * down.x() + column * right.x();
    double dy = corner.y() + row * down.y() + column * right.y();
    double dz = corner.z() + row * down.z() + column * right.z();
    double x = solid.ex + depth * dx;
    double y = solid.ey + depth * dy;
    double z = solid.ez + depth * dz;
    solid.findNormal(x, y, z);
    double base = ambient + appearance.glow();
    double red = base;
    double green = base;
    double blue = base;
    double highlight = 0;
    for (int i = 0, light = 0; i < lamps.length; i++, light += 6) {
      double lx = lights[light];
      double ly = lights[light + 1];
      double lz = lights[light + 2];
      if (lamps[i]) {
        lx -= x;
        ly -= y;
        lz -= z;
        double length = Math.sqrt(lx * lx + ly * ly + lz * lz);
        lx /= length;
        ly /= length;
        lz /= length;
      }
      double cosine = solid.nx * lx + solid.ny * ly + solid.nz * lz;
      if (cosine > 0) {
        red += cosine * lights[light + 3];
        green += cosine * lights[light + 4];
        blue += cosine * lights[light + 5];
        if (appearance.shine() > 0) {
          highlight += gloss(dx, dy, dz, lx, ly, lz);
        }
      }
    }
    Colour colour = colourAt(x, y, z);
    highlight *= appearance.shine();
    rgb[at] = level(red * colour.red() + highlight);
    rgb[at + 1] = level(green * colour.green() + highlight);
    rgb[at + 2] = level(blue * colour.blue() + highlight);
  }

  /** The 32nd power of the cosine between the normal and the middle of light and eye. */
  private double gloss(double dx, double dy, double dz, double lx, double ly, double lz) {
    double toEye = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
    double hx = lx - dx * toEye;
    double hy = ly - dy * toEye;
    double hz = lz - dz * toEye;
    double cosine =
        (solid.nx * hx + solid.ny * hy + solid.nz * hz) / Math.sqrt(hx * hx + hy * hy + hz * hz);
    if (!(cosine > 0)) {
      return 0;
    }
    double power = cosine * cosine;
    power *= power;
    power *= power;
    power *= power;
    return power * power;
  }

  private Colour colourAt(double x, double y, double z) {
    if (appearance.second() == null) {
      return appearance.colour();
    }
    double tile = appearance.tile();
    // A hair is added so that a face on a border is of one colour.
    long sum =
        (long) Math.floor(x / tile + 1e-6)
            + (long) Math.floor(y / tile + 1e-6)
            + (long) Math.floor(z / tile + 1e-6);
    return (sum & 1) == 0 ? appearance.colour() : appearance.second();
  }

  static byte level(double intensity) {
    double scaled = intensity * 255 + 0.5;
    return (byte) (scaled >= 255 ? 255 : scaled <= 0 ? 0 : (int) scaled);
  }
}

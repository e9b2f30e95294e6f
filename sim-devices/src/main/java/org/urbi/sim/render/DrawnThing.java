package org.urbi.sim.render;

import java.util.List;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Vec3;

/** A thing as one camera sees it: which pixels it may cover, how far away it is, how it is lit. */
final class DrawnThing {
  private final Appearance appearance;
  private final Solid solid;

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

  DrawnThing(Thing thing, Pose camera, Lens lens, List<Light> sceneLights) {
    appearance = thing.appearance();
    Pose fromCamera = camera.inverse().apply(thing.pose());
    Pose toShape = fromCamera.inverse();
    solid = Solid.of(thing.shape(), toShape.position());
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

  /** The pixels that the box around the shape covers: all of them where it reaches the camera. */
  private int[] covered(Pose fromCamera, Lens lens) {
    Vec3 half = solid.halfExtent();
    int[] all = {0, 0, lens.width(), lens.height()};
    if (half == null) {
      return all;
    }
    double minX = Double.POSITIVE_INFINITY;
    double minY = Double.POSITIVE_INFINITY;
    double maxX = Double.NEGATIVE_INFINITY;
    double maxY = Double.NEGATIVE_INFINITY;
    int behind = 0;
    for (int i = 0; i < 8; i++) {
      Vec3 sign = new Vec3((i & 1) * 2 - 1, (i & 2) - 1, (i >> 1 & 2) - 1);
      Vec3 p =
          fromCamera.apply(new Vec3(half.x() * sign.x(), half.y() * sign.y(), half.z() * sign.z()));
      if (p.x() < lens.near()) {
        behind++;
        continue;
      }
      double x = lens.width() / 2.0 - p.y() / p.x() * lens.focalLength();
      double y = lens.height() / 2.0 - p.z() / p.x() * lens.focalLength();
      minX = Math.min(minX, x);
      minY = Math.min(minY, y);
      maxX = Math.max(maxX, x);
      maxY = Math.max(maxY, y);
    }
    if (behind == 8) {
      return new int[4];
    }
    if (behind > 0) {
      return all;
    }
    return new int[] {
      (int) Math.max(0, Math.floor(minX)),
      (int) Math.max(0, Math.floor(minY)),
      (int) Math.min(lens.width(), Math.ceil(maxX) + 1),
      (int) Math.min(lens.height(), Math.ceil(maxY) + 1)
    };
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
            solid.meet(dx + column * right.x(), dy + column * right.y(), dz + column * right.z());
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

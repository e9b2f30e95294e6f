package org.urbi.sim.render;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.geometry.Vec3;

/**
 * A shape for ray casting from one eye. All coordinates are in the frame of the shape: the eye is
 * at (ex, ey, ez), and a ray is the eye plus t times a direction, whose length need not be 1.
 */
abstract class RayShape {
  /** Of no intersection. */
  static final double MISS = Double.POSITIVE_INFINITY;

  final double ex;
  final double ey;
  final double ez;

  /** The normal at the point last asked for. */
  double nx;

  double ny;
  double nz;

  private RayShape(Vec3 eye) {
    ex = eye.x();
    ey = eye.y();
    ez = eye.z();
  }

  static RayShape of(Shape shape, Vec3 eye) {
    return switch (shape) {
      case Shape.Sphere s -> new RaySphere(eye, s.radius());
      case Shape.Box b -> new RayBox(eye, b.x() / 2, b.y() / 2, b.z() / 2);
      case Shape.Cylinder c -> new RayCylinder(eye, c.radius(), c.length() / 2, false);
      case Shape.Capsule c -> new RayCylinder(eye, c.radius(), c.length() / 2, true);
      case Shape.Plane p -> new RayPlane(eye);
    };
  }

  /** The smallest t at which a ray from outside comes in; {@link #MISS} for none. */
  abstract double intersect(double dx, double dy, double dz);

  /** Finds the normal, of length 1, at a point of the surface. */
  abstract void findNormal(double x, double y, double z);

  final void setNormal(double x, double y, double z) {
    nx = x;
    ny = y;
    nz = z;
  }

  /** Half the edges of the smallest box around it; null for one that ends nowhere. */
  abstract @Nullable Vec3 halfExtent();

  private static final class RaySphere extends RayShape {
    private final double radius;
    private final double c;

    RaySphere(Vec3 eye, double radius) {
      super(eye);
      this.radius = radius;
      c = eye.dot(eye) - radius * radius;
    }

    @Override
    double intersect(double dx, double dy, double dz) {
      double a = dx * dx + dy * dy + dz * dz;
      double b = ex * dx + ey * dy + ez * dz;
      double d = b * b - a * c;
      return d < 0 || c < 0 ? MISS : (-b - Math.sqrt(d)) / a;
    }

    @Override
    void findNormal(double x, double y, double z) {
      setNormal(x / radius, y / radius, z / radius);
    }

    @Override
    Vec3 halfExtent() {
      return new Vec3(radius, radius, radius);
    }
  }

  private static final class RayBox extends RayShape {
    private final double hx;
    private final double hy;
    private final double hz;

    RayBox(Vec3 eye, double hx, double hy, double hz) {
      super(eye);
      this.hx = hx;
      this.hy = hy;
      this.hz = hz;
    }

    @Override
    double intersect(double dx, double dy, double dz) {
      // A direction along a face divides by 0; the infinities that result compare as they should.
      double x1 = (-hx - ex) / dx;
      double x2 = (hx - ex) / dx;
      double y1 = (-hy - ey) / dy;
      double y2 = (hy - ey) / dy;
      double z1 = (-hz - ez) / dz;
      double z2 = (hz - ez) / dz;
      double in = Math.max(Math.max(Math.min(x1, x2), Math.min(y1, y2)), Math.min(z1, z2));
      double out = Math.min(Math.min(Math.max(x1, x2), Math.max(y1, y2)), Math.max(z1, z2));
      return in <= out && in > 0 ? in : MISS;
    }

    @Override
    void findNormal(double x, double y, double z) {
      double gapX = Math.abs(hx - Math.abs(x));
      double gapY = Math.abs(hy - Math.abs(y));
      double gapZ = Math.abs(hz - Math.abs(z));
      if (gapX <= gapY && gapX <= gapZ) {
        setNormal(Math.signum(x), 0, 0);
      } else if (gapY <= gapZ) {
        setNormal(0, Math.signum(y), 0);
      } else {
        setNormal(0, 0, Math.signum(z));
      }
    }

    @Override
    Vec3 halfExtent() {
      return new Vec3(hx, hy, hz);
    }
  }

  /** A cylinder, with flat or with round ends. */
  private static final class RayCylinder extends RayShape {
    private final double radius;
    private final double half;
    private final boolean round;
    private final double c;

    RayCylinder(Vec3 eye, double radius, double half, boolean round) {
      super(eye);
      this.radius = radius;
      this.half = half;
      this.round = round;
      c = eye.x() * eye.x() + eye.y() * eye.y() - radius * radius;
    }

    @Override
    double intersect(double dx, double dy, double dz) {
      double side = intersectSide(dx, dy, dz);
      if (side != MISS) {
        return side;
      }
      return round
          ? Math.min(intersectDome(dx, dy, dz, half), intersectDome(dx, dy, dz, -half))
          : intersectLid(dx, dy, dz);
    }

    private double intersectSide(double dx, double dy, double dz) {
      double a = dx * dx + dy * dy;
      double b = ex * dx + ey * dy;
      double d = b * b - a * c;
      if (d < 0 || c < 0 || a == 0) {
        return MISS;
      }
      double t = (-b - Math.sqrt(d)) / a;
      return t > 0 && Math.abs(ez + t * dz) <= half ? t : MISS;
    }

    private double intersectLid(double dx, double dy, double dz) {
      double lid = ez > 0 ? half : -half;
      double t = (lid - ez) / dz;
      double x = ex + t * dx;
      double y = ey + t * dy;
      return Math.abs(ez) > half && t > 0 && x * x + y * y <= radius * radius ? t : MISS;
    }

    private double intersectDome(double dx, double dy, double dz, double centre) {
      double z = ez - centre;
      double a = dx * dx + dy * dy + dz * dz;
      double b = ex * dx + ey * dy + z * dz;
      double inside = ex * ex + ey * ey + z * z - radius * radius;
      double d = b * b - a * inside;
      if (d < 0 || inside < 0) {
        return MISS;
      }
      double t = (-b - Math.sqrt(d)) / a;
      return t > 0 ? t : MISS;
    }

    @Override
    void findNormal(double x, double y, double z) {
      double beyond = Math.abs(z) - half;
      if (beyond < 0) {
        setNormal(x / radius, y / radius, 0);
      } else if (round) {
        setNormal(x / radius, y / radius, Math.signum(z) * beyond / radius);
      } else if (x * x + y * y >= radius * radius * (1 - 1e-9) && beyond < 1e-9) {
        setNormal(x / radius, y / radius, 0);
      } else {
        setNormal(0, 0, Math.signum(z));
      }
    }

    @Override
    Vec3 halfExtent() {
      return new Vec3(radius, radius, round ? half + radius : half);
    }
  }

  private static final class RayPlane extends RayShape {
    RayPlane(Vec3 eye) {
      super(eye);
    }

    @Override
    double intersect(double dx, double dy, double dz) {
      return ez > 0 && dz < 0 ? -ez / dz : MISS;
    }

    @Override
    void findNormal(double x, double y, double z) {
      setNormal(0, 0, 1);
    }

    @Override
    @Nullable Vec3 halfExtent() {
      return null;
    }
  }
}

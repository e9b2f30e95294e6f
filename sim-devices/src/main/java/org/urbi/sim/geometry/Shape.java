package org.urbi.sim.geometry;

/** What a part of a body looks like, around the origin of its own frame. */
public sealed interface Shape {
  /** In cubic metres; infinite for a plane. */
  double volume();

  /** The moments of inertia about x, y and z for a mass of 1 kg. */
  Vec3 unitInertia();

  /** How far from the origin its farthest point is. */
  double boundingRadius();

  record Sphere(double radius) implements Shape {
    public Sphere {
      SizeLimits.check(radius);
    }

    @Override
    public double volume() {
      return 4.0 / 3 * Math.PI * radius * radius * radius;
    }

    @Override
    public Vec3 unitInertia() {
      double i = 0.4 * radius * radius;
      return new Vec3(i, i, i);
    }

    @Override
    public double boundingRadius() {
      return radius;
    }
  }

  /** A box with these edges. */
  record Box(double x, double y, double z) implements Shape {
    public Box {
      SizeLimits.check(x, y, z);
    }

    @Override
    public double volume() {
      return x * y * z;
    }

    @Override
    public Vec3 unitInertia() {
      return new Vec3((y * y + z * z) / 12, (x * x + z * z) / 12, (x * x + y * y) / 12);
    }

    @Override
    public double boundingRadius() {
      return Math.sqrt(x * x + y * y + z * z) / 2;
    }
  }

  /** Along the z axis. */
  record Cylinder(double radius, double length) implements Shape {
    public Cylinder {
      SizeLimits.check(radius, length);
    }

    @Override
    public double volume() {
      return Math.PI * radius * radius * length;
    }

    @Override
    public Vec3 unitInertia() {
      double across = radius * radius / 4 + length * length / 12;
      return new Vec3(across, across, radius * radius / 2);
    }

    @Override
    public double boundingRadius() {
      return Math.sqrt(radius * radius + length * length / 4);
    }
  }

  /** A cylinder along the z axis with half a sphere at each end; the length is without these. */
  record Capsule(double radius, double length) implements Shape {
    public Capsule {
      SizeLimits.check(radius, length);
    }

    @Override
    public double volume() {
      return tube() + caps();
    }

    private double tube() {
      return Math.PI * radius * radius * length;
    }

    private double caps() {
      return 4.0 / 3 * Math.PI * radius * radius * radius;
    }

    @Override
    public Vec3 unitInertia() {
      double tube = tube() / volume();
      double caps = caps() / volume();
      double r2 = radius * radius;
      double across =
          tube * (r2 / 4 + length * length / 12)
              + caps * (0.4 * r2 + 0.375 * radius * length + 0.25 * length * length);
      return new Vec3(across, across, tube * r2 / 2 + caps * 0.4 * r2);
    }

    @Override
    public double boundingRadius() {
      return radius + length / 2;
    }
  }

  /** Everything below z = 0 is solid; only for what does not move. */
  record Plane() implements Shape {
    @Override
    public double volume() {
      return Double.POSITIVE_INFINITY;
    }

    @Override
    public Vec3 unitInertia() {
      return Vec3.ZERO;
    }

    @Override
    public double boundingRadius() {
      return Double.POSITIVE_INFINITY;
    }
  }
}

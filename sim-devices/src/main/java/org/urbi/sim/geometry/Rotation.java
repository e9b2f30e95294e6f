package org.urbi.sim.geometry;

/** A rotation: a quaternion of length 1. */
public record Rotation(double w, double x, double y, double z) {
  public static final Rotation NONE = new Rotation(1, 0, 0, 0);

  /** By an angle about an axis, counter-clockwise for who looks against it. */
  public static Rotation about(Vec3 axis, double angle) {
    Vec3 n = axis.normalized();
    double s = StrictMath.sin(angle / 2);
    return new Rotation(StrictMath.cos(angle / 2), n.x() * s, n.y() * s, n.z() * s);
  }

  /** First about x, then y, then z: all axes of the outer frame. */
  public static Rotation rollPitchYaw(double roll, double pitch, double yaw) {
    return about(Vec3.Z, yaw).times(about(Vec3.Y, pitch)).times(about(Vec3.X, roll));
  }

  /** The shortest one that turns a direction into another. */
  public static Rotation between(Vec3 from, Vec3 to) {
    Vec3 a = from.normalized();
    Vec3 b = to.normalized();
    double cosine = a.dot(b);
    if (cosine < -1 + 1e-12) {
      Vec3 aside = Math.abs(a.x()) < 0.9 ? a.cross(Vec3.X) : a.cross(Vec3.Y);
      return about(aside, Math.PI);
    }
    Vec3 axis = a.cross(b);
    return new Rotation(1 + cosine, axis.x(), axis.y(), axis.z()).normalized();
  }

  /** This after the other. */
  public Rotation times(Rotation o) {
    return new Rotation(
        w * o.w - x * o.x - y * o.y - z * o.z,
        w * o.x + x * o.w + y * o.z - z * o.y,
        w * o.y - x * o.z + y * o.w + z * o.x,
        w * o.z + x * o.y - y * o.x + z * o.w);
  }

  public Rotation inverse() {
    return new Rotation(w, -x, -y, -z);
  }

  public Vec3 apply(Vec3 v) {
    double tx = 2 * (y * v.z() - z * v.y());
    double ty = 2 * (z * v.x() - x * v.z());
    double tz = 2 * (x * v.y() - y * v.x());
    return new Vec3(
        v.x() + w * tx + y * tz - z * ty,
        v.y() + w * ty + z * tx - x * tz,
        v.z() + w * tz + x * ty - y * tx);
  }

  /** The angle about the z axis, between -π and π, that {@link #rollPitchYaw} would need. */
  public double yaw() {
    return StrictMath.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
  }

  /** This rotation as a quaternion of length 1. */
  public Rotation normalized() {
    double length = Math.sqrt(w * w + x * x + y * y + z * z);
    return new Rotation(w / length, x / length, y / length, z / length);
  }

  public boolean isFinite() {
    return Double.isFinite(w) && Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z);
  }
}

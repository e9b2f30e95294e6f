package org.urbi.sim.geometry;

/** Where something is, and how it is turned. */
public record Pose(Vec3 position, Rotation rotation) {
  public static final Pose ORIGIN = new Pose(Vec3.ZERO, Rotation.NONE);

  public static Pose at(double x, double y, double z) {
    return new Pose(new Vec3(x, y, z), Rotation.NONE);
  }

  public static Pose at(Vec3 position) {
    return new Pose(position, Rotation.NONE);
  }

  /** A point of this frame, in the outer one. */
  public Vec3 apply(Vec3 point) {
    return position.plus(rotation.apply(point));
  }

  /** A pose in this frame, in the outer one. */
  public Pose apply(Pose inner) {
    return new Pose(apply(inner.position), rotation.times(inner.rotation));
  }

  /** The pose that undoes this one. */
  public Pose inverse() {
    Rotation back = rotation.inverse();
    return new Pose(back.apply(position.times(-1)), back);
  }

  public boolean isFinite() {
    return position.isFinite() && rotation.isFinite();
  }
}

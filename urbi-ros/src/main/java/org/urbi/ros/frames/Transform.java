package org.urbi.ros.frames;

/**
 * Where a frame is in another one: first turned, then moved.
 *
 * @param x metres; so are {@code y} and {@code z}
 * @param qx with {@code qy}, {@code qz} and {@code qw} a quaternion of length 1
 */
public record Transform(double x, double y, double z, double qx, double qy, double qz, double qw) {
  /** Where it is already. */
  public static final Transform IDENTITY = new Transform(0, 0, 0, 0, 0, 0, 1);

  /** Quaternions that are as far apart as this, or less, are interpolated along a line. */
  private static final double NEAR = 0.9995;

  /**
   * The same with a quaternion of length 1.
   *
   * @throws FrameException if it has no direction, or one of the numbers is NaN or infinite
   */
  public Transform normalized() {
    double length = Math.sqrt(qx * qx + qy * qy + qz * qz + qw * qw);
    double sum = x + y + z + length;
    if (Double.isNaN(sum) || Double.isInfinite(sum) || length < 1e-6) {
      throw new FrameException(
          "a rotation without a direction, or a number that is NaN or infinite");
    }
    return new Transform(x, y, z, qx / length, qy / length, qz / length, qw / length);
  }

  /** Where something is that is so within a frame which itself is here. */
  public Transform then(Transform within) {
    double[] moved = turn(within.x, within.y, within.z);
    return new Transform(
        x + moved[0],
        y + moved[1],
        z + moved[2],
        qw * within.qx + qx * within.qw + qy * within.qz - qz * within.qy,
        qw * within.qy - qx * within.qz + qy * within.qw + qz * within.qx,
        qw * within.qz + qx * within.qy - qy * within.qx + qz * within.qw,
        qw * within.qw - qx * within.qx - qy * within.qy - qz * within.qz);
  }

  /** Where the other frame is in this one. */
  public Transform inverse() {
    Transform back = new Transform(0, 0, 0, -qx, -qy, -qz, qw);
    double[] moved = back.turn(-x, -y, -z);
    return new Transform(moved[0], moved[1], moved[2], -qx, -qy, -qz, qw);
  }

  private double[] turn(double px, double py, double pz) {
    double tx = 2 * (qy * pz - qz * py);
    double ty = 2 * (qz * px - qx * pz);
    double tz = 2 * (qx * py - qy * px);
    return new double[] {
      px + qw * tx + qy * tz - qz * ty,
      py + qw * ty + qz * tx - qx * tz,
      pz + qw * tz + qx * ty - qy * tx
    };
  }

  /**
   * Between this and another one, turning by the shorter way.
   *
   * @param share 0 for this one, 1 for the other one
   */
  public Transform towards(Transform other, double share) {
    double cosine = qx * other.qx + qy * other.qy + qz * other.qz + qw * other.qw;
    double sign = cosine < 0 ? -1 : 1;
    double ours = 1 - share;
    double theirs = share;
    if (cosine * sign < NEAR) {
      double angle = Math.acos(cosine * sign);
      ours = Math.sin((1 - share) * angle) / Math.sin(angle);
      theirs = Math.sin(share * angle) / Math.sin(angle);
    }
    theirs *= sign;
    return new Transform(
            x + share * (other.x - x),
            y + share * (other.y - y),
            z + share * (other.z - z),
            ours * qx + theirs * other.qx,
            ours * qy + theirs * other.qy,
            ours * qz + theirs * other.qz,
            ours * qw + theirs * other.qw)
        .normalized();
  }
}

package org.urbi.sim.physics;

import java.util.List;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.BodyDescription.Part;

/**
 * Mass, its centre, and the inertia about that centre.
 *
 * @param inertia Ixx, Iyy, Izz, Ixy, Ixz, Iyz, in kg·m²
 */
record MassProperties(double mass, Vec3 centre, double[] inertia) {
  /** The properties of parts of one density that overlap nowhere. */
  static MassProperties of(double mass, List<Part> parts) {
    double volume = parts.stream().mapToDouble(p -> p.shape().volume()).sum();
    Vec3 centre = Vec3.ZERO;
    for (Part part : parts) {
      centre = centre.plus(part.pose().position().times(part.shape().volume() / volume));
    }
    double[] inertia = new double[6];
    for (Part part : parts) {
      double share = mass * part.shape().volume() / volume;
      addTurned(inertia, part.shape().unitInertia().times(share), part.pose().rotation());
      addDistant(inertia, part.pose().position().minus(centre), share);
    }
    return new MassProperties(mass, centre, inertia);
  }

  /**
   * Whether an engine can divide by the inertia: all three of its moments are there (by Cholesky's
   * decomposition), and none is nothing beside the others.
   */
  boolean isUsable() {
    double[] i = inertia;
    double least = 1e-12 * (i[0] + i[1] + i[2]);
    double yy = i[1] - i[3] * i[3] / i[0];
    double yz = i[5] - i[3] * i[4] / i[0];
    double zz = i[2] - i[4] * i[4] / i[0] - yz * yz / yy;
    return i[0] > least && yy > least && zz > least;
  }

  /** R · diag(moments) · Rᵀ */
  private static void addTurned(double[] inertia, Vec3 moments, Rotation rotation) {
    Vec3 a = rotation.apply(Vec3.X);
    Vec3 b = rotation.apply(Vec3.Y);
    Vec3 c = rotation.apply(Vec3.Z);
    Vec3 m = moments;
    inertia[0] += m.x() * a.x() * a.x() + m.y() * b.x() * b.x() + m.z() * c.x() * c.x();
    inertia[1] += m.x() * a.y() * a.y() + m.y() * b.y() * b.y() + m.z() * c.y() * c.y();
    inertia[2] += m.x() * a.z() * a.z() + m.y() * b.z() * b.z() + m.z() * c.z() * c.z();
    inertia[3] += m.x() * a.x() * a.y() + m.y() * b.x() * b.y() + m.z() * c.x() * c.y();
    inertia[4] += m.x() * a.x() * a.z() + m.y() * b.x() * b.z() + m.z() * c.x() * c.z();
    inertia[5] += m.x() * a.y() * a.z() + m.y() * b.y() * b.z() + m.z() * c.y() * c.z();
  }

  /** Steiner's share of a mass away from the centre. */
  private static void addDistant(double[] inertia, Vec3 d, double mass) {
    inertia[0] += mass * (d.y() * d.y() + d.z() * d.z());
    inertia[1] += mass * (d.x() * d.x() + d.z() * d.z());
    inertia[2] += mass * (d.x() * d.x() + d.y() * d.y());
    inertia[3] -= mass * d.x() * d.y();
    inertia[4] -= mass * d.x() * d.z();
    inertia[5] -= mass * d.y() * d.z();
  }
}

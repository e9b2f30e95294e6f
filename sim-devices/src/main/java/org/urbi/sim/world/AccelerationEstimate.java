package org.urbi.sim.world;

import org.urbi.sim.geometry.Vec3;
import org.urbi.sim.physics.PhysicsSettings;

/** Estimates the acceleration at a sensor from the speeds before and after a step. */
final class AccelerationEstimate {
  private final Mount.Accelerometer mount;
  private final PhysicsSettings settings;
  private Vec3 velocity;
  private Vec3 acceleration = Vec3.ZERO;

  AccelerationEstimate(Mount.Accelerometer mount, PhysicsSettings settings) {
    this.mount = mount;
    this.settings = settings;
    velocity = mount.body().velocityAt(mount.pose().position());
  }

  /** What moves from now on has not been pushed there. */
  void restart() {
    velocity = mount.body().velocityAt(mount.pose().position());
    acceleration = Vec3.ZERO;
  }

  void afterStep() {
    Vec3 now = mount.body().velocityAt(mount.pose().position());
    acceleration = now.minus(velocity).times(1 / settings.step());
    velocity = now;
  }

  /**
   * What an accelerometer measures, in its own frame: not what gravity does, but what resists it.
   */
  Vec3 acceleration() {
    return mount.worldPose().rotation().inverse().apply(acceleration.minus(settings.gravity()));
  }
}

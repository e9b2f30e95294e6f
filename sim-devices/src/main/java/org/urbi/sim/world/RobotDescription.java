package org.urbi.sim.world;

/**
 * What a world file says of a robot on two wheels.
 *
 * @param kind as in the interface Identity: {@code wheeled} and so on
 * @param left the drive of its left wheels; null if it does not move
 * @param radius of the wheels, in metres
 * @param track the distance of the wheels, in metres
 */
public record RobotDescription(
    String name, String kind, String model, Drive left, Drive right, double radius, double track) {
  /** Whether it can be driven. */
  public boolean mobile() {
    return left != null;
  }
}

package org.urbi.sim.physics;

import org.urbi.sim.geometry.Vec3;

/**
 * Where two bodies touched in the last step.
 *
 * @param firstPart which part of the first body it was
 * @param normal away from the second body
 * @param depth how deep they are in each other, in metres
 */
public record Contact(
    Body first,
    int firstPart,
    Body second,
    int secondPart,
    Vec3 position,
    Vec3 normal,
    double depth) {
  /** Whether a body is one of the two. */
  public boolean involves(Body body) {
    return first == body || second == body;
  }
}

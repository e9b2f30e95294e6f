package org.urbi.sim.physics;

/** Something that the physics cannot do, in words for the user who asked for it. */
public class PhysicsException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public PhysicsException(String message) {
    super(message);
  }

  public PhysicsException(String message, Throwable cause) {
    super(message, cause);
  }

  /** The number itself, unless it is not one. */
  static double finite(double number, String what) {
    if (!Double.isFinite(number)) {
      throw new PhysicsException(what + ": not a finite number: " + number);
    }
    return number;
  }
}

package org.urbi.sim;

/** Something that the simulation cannot do, in words for the user who asked for it. */
public class SimulationException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public SimulationException(String message) {
    super(message);
  }

  public SimulationException(String message, Throwable cause) {
    super(message, cause);
  }

  /**
   * The number itself.
   *
   * @throws SimulationException if it is NaN or infinite
   */
  public static double finite(double number, String what) {
    if (!Double.isFinite(number)) {
      throw new SimulationException(what + ": not a finite number: " + number);
    }
    return number;
  }
}

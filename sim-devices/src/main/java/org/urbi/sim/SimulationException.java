package org.urbi.sim;

import org.jspecify.annotations.Nullable;

/** An operation that the simulation cannot perform; the message is for the user. */
public class SimulationException extends IllegalStateException {
  private static final long serialVersionUID = 1L;

  public SimulationException(String message) {
    super(message);
  }

  public SimulationException(@Nullable String message, Throwable cause) {
    super(message, cause);
  }

  /** No stack trace: people do not want to know where in this module it was thrown. */
  @Override
  public synchronized Throwable fillInStackTrace() {
    return this;
  }

  /**
   * What a component has got from its {@code init}.
   *
   * @throws SimulationException if that has not been called
   */
  public static <T> T ready(@Nullable T part) {
    if (part == null) {
      throw new SimulationException("init has not been called");
    }
    return part;
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

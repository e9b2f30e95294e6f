package org.urbi.kernel.node;

import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.object.UrbiObject;

/**
 * {@code return}, {@code break} and {@code continue} as exceptions, where the surrounding
 * statements cannot check for them: inside an expression, or in another job than the code that they
 * leave.
 */
abstract class NonLocalExit extends ControlFlowException {
  /** Leaves a function. */
  static final class Return extends NonLocalExit {
    private final transient Frame activation;
    private final transient UrbiObject value;

    Return(Frame activation, UrbiObject value) {
      this.activation = activation;
      this.value = value;
    }

    Frame activation() {
      return activation;
    }

    UrbiObject value() {
      return value;
    }
  }

  /** Leaves the innermost loop. */
  static final class Break extends NonLocalExit {}

  /** Leaves this turn of the innermost loop. */
  static final class Continue extends NonLocalExit {}
}

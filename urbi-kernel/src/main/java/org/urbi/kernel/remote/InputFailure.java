package org.urbi.kernel.remote;

import org.urbi.kernel.error.Problem;
import org.urbi.kernel.log.FailureLog;
import urbi.wire.WireException;

/** What is said to a remote process when something was thrown at what it has sent. */
public final class InputFailure {
  private InputFailure() {}

  /**
   * The reason for which its connection is closed. If it is a defect of ours, that is logged with
   * its stack.
   */
  public static String text(RuntimeException failure) {
    if (failure instanceof WireException || failure instanceof IllegalArgumentException) {
      return Problem.PROTOCOL_BROKEN.text(String.valueOf(failure.getMessage()));
    }
    FailureLog.internal("reading what a remote process has sent", failure);
    return FailureLog.text(failure);
  }
}

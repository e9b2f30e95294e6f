package org.urbi.bridge;

import urbi.spi.Failure;
import urbi.thread.InternalFailure;
import urbi.wire.WireException;

/** What C++ code is told when its request fails. */
final class RequestFailure {
  private RequestFailure() {}

  /** The text of the exception that it gets; a defect of ours is logged with its stack. */
  static String text(Throwable failure) {
    if (!(failure instanceof WireException) && Failure.isDefect(failure)) {
      InternalFailure.log("a request of C++ code", failure);
      return InternalFailure.text(failure);
    }
    String message = failure.getMessage();
    return message == null || message.isEmpty() ? failure.getClass().getSimpleName() : message;
  }
}

package org.urbi.bridge;

import urbi.UCastException;
import urbi.UClientException;
import urbi.thread.InternalFailure;
import urbi.wire.WireException;

/** What C++ code is told when its request fails. */
final class RequestFailure {
  private RequestFailure() {}

  /** The text of the exception that it gets; a defect of ours is logged with its stack. */
  static String text(Throwable failure) {
    if (isDefect(failure)) {
      InternalFailure.log("a request of C++ code", failure);
      return InternalFailure.text(failure);
    }
    String message = failure.getMessage();
    return message == null || message.isEmpty() ? failure.getClass().getSimpleName() : message;
  }

  /** What the kernel refuses, and what passes through Java code, has no stack. */
  private static boolean isDefect(Throwable failure) {
    return switch (failure) {
      case StackOverflowError e -> false;
      case Error e -> true;
      case IllegalArgumentException e -> false;
      case IllegalStateException e -> false;
      case UCastException e -> false;
      case UClientException e -> false;
      case WireException e -> false;
      case InterruptedException e -> false;
      default -> failure.getStackTrace().length > 0;
    };
  }
}

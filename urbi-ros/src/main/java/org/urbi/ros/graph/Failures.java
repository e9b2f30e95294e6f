package org.urbi.ros.graph;

import java.io.IOException;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import urbi.UCastException;
import urbi.thread.InternalFailure;

/** What people and peers are told of a failure: its message, unless it is a defect of ours. */
public final class Failures {
  private Failures() {}

  /** What was thrown, without what a promise has wrapped it in. */
  public static Throwable cause(Throwable failure) {
    Throwable cause = failure;
    while ((cause instanceof CompletionException || cause instanceof ExecutionException)
        && cause.getCause() != null) {
      cause = cause.getCause();
    }
    return cause;
  }

  /**
   * Whether nobody else can have caused it. What is thrown for people has no stack, and the network
   * and what is sent by it are the business of others.
   */
  public static boolean isDefect(Throwable cause) {
    boolean isOfOthers =
        cause instanceof IOException
            || cause instanceof IllegalArgumentException
            || cause instanceof UCastException
            || cause instanceof TimeoutException
            || cause instanceof CancellationException
            || cause instanceof InterruptedException;
    return cause instanceof Error || !isOfOthers && cause.getStackTrace().length > 0;
  }

  /** Its text. */
  public static String text(Throwable failure) {
    Throwable cause = cause(failure);
    String message = cause.getMessage();
    if (isDefect(cause)) {
      return InternalFailure.text(cause);
    }
    return message == null ? cause.getClass().getSimpleName() : message;
  }

  /**
   * Its text; a defect is logged with its stack.
   *
   * @param doing what has failed, for the log
   */
  public static String told(String doing, Throwable failure) {
    Throwable cause = cause(failure);
    if (isDefect(cause)) {
      InternalFailure.log(doing, cause);
    }
    return text(cause);
  }
}

package org.urbi.ros.uobject;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.urbi.ros.graph.RosException;
import urbi.UVar;

/** For how long urbiscript waits for an answer, by a variable that it may set: seconds. */
final class Patience {
  /** Seconds. */
  private static final int USUAL = 60;

  private final UVar seconds;

  /**
   * @param seconds is set to what is usual
   */
  Patience(UVar seconds) {
    this.seconds = seconds;
    seconds.setValue(USUAL);
  }

  /**
   * How long it is now.
   *
   * @throws RosException if it is no time
   */
  long milliseconds() {
    double wanted = seconds.doubleValue();
    if (!(wanted > 0)) {
      throw new RosException("patience: seconds, more than 0, expected, or inf");
    }
    return (long) Math.ceil(wanted * 1000);
  }

  /**
   * The answer; fails when it takes too long. The promise ends then, and when the answer is
   * cancelled because the job that waits was stopped: nobody need keep it.
   *
   * @param who does not answer
   * @param most milliseconds
   */
  static <T> CompletableFuture<T> within(long most, String who, CompletableFuture<T> answer) {
    CompletableFuture<T> awaited =
        answer
            .orTimeout(most, TimeUnit.MILLISECONDS)
            .exceptionallyCompose(failure ->
                CompletableFuture.failedFuture(
                    failure instanceof TimeoutException
                        ? new RosException(
                            who + " has not answered within " + most + " ms", failure)
                        : failure));
    awaited.whenComplete((value, failure) -> {
      if (awaited.isCancelled()) {
        answer.cancel(false);
      }
    });
    return awaited;
  }
}

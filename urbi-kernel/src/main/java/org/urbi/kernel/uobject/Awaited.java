package org.urbi.kernel.uobject;

import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;

/** A result that a job waits for while others run. */
final class Awaited {
  private final Job job;
  private Object value;
  private Throwable failure;
  private boolean done;
  private boolean abandoned;

  Awaited(Job job) {
    this.job = job;
  }

  /**
   * Waits for the result.
   *
   * @throws CompletionException if it is a failure
   */
  Object await(CompletionStage<?> stage) {
    Scheduler scheduler = job.scheduler();
    scheduler.pace().begin();
    stage.whenComplete((result, thrown) ->
        scheduler
            .inbox()
            .post(() -> {
              scheduler.pace().end();
              value = result;
              failure = thrown;
              done = true;
              if (!abandoned) {
                job.wake();
              }
            }));
    try {
      while (!done) {
        job.waitForWake();
      }
    } finally {
      abandoned = true;
    }
    if (failure != null) {
      throw new CompletionException(failure);
    }
    return value;
  }
}

package org.urbi.kernel.uobject;

import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.PendingAnswer;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.message.Outcome;

/** A result that a job waits for while others run. */
final class AwaitedResult {
  private final Scheduler scheduler;
  private final PendingAnswer answer;
  private boolean waiting;

  AwaitedResult(Job job) {
    scheduler = job.scheduler();
    answer = new PendingAnswer(job, Wait.COMPONENT);
  }

  /**
   * Waits for the result.
   *
   * @throws CompletionException if the result is a failure
   */
  @Nullable Object await(CompletionStage<?> stage) {
    stage.whenComplete((result, thrown) -> complete(new Outcome(result, thrown)));
    waiting = true;
    Outcome outcome = answer.await();
    if (outcome.failure() != null) {
      throw new CompletionException(outcome.failure());
    }
    return outcome.value();
  }

  /**
   * Delivers the outcome. If the kernel thread completes the wait, a recorded message has caused
   * that. If the result was there before the wait began, its time is unknown, so it is posted as a
   * message.
   */
  private void complete(Outcome outcome) {
    if (scheduler.isKernelThread() && waiting) {
      answer.arrived(outcome);
    } else {
      answer.post(outcome);
    }
  }
}

package org.urbi.kernel.uobject;

import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.PendingAnswer;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.message.Outcome;

/**
 * A result that a job waits for while others run. If the job is stopped, nobody wants it any more.
 */
final class AwaitedResult {
  /** Seconds that a replay gives a component for what it had done in the recorded run. */
  private static final int PATIENCE = 2;

  private final Scheduler scheduler;
  private final PendingAnswer answer;
  private boolean waiting;
  private boolean there;

  /** What the kernel thread itself has brought about; it passes no inbox. */
  private @Nullable Object own;

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
    stage.whenComplete(this::complete);
    waiting = true;
    if (scheduler.journal().isReplay()) {
      answer.before(() -> catchUp(stage));
    }
    Outcome outcome;
    try {
      outcome = answer.await();
    } finally {
      // What comes now comes as a message, as in the recorded run, or for nobody.
      waiting = false;
    }
    there = true;
    return switch (outcome) {
      case Outcome.Value value -> own == null ? value.data().value() : own;
      case Outcome.Failure failure -> throw new CompletionException(failure.thrown());
    };
  }

  /**
   * Waits for the result of a stage. If the job is stopped, the stage is cancelled, so that the
   * component need not go on.
   *
   * @param troubles are told what a stage throws that does not want to be cancelled
   * @throws CompletionException if the result is a failure
   */
  @Nullable Object await(CompletionStage<?> stage, Consumer<Throwable> troubles) {
    try {
      return await(stage);
    } finally {
      if (!there) {
        cancel(stage, troubles);
      }
    }
  }

  private static void cancel(CompletionStage<?> stage, Consumer<Throwable> troubles) {
    try {
      // Of a stage that cannot be completed by others, this is a copy.
      stage.toCompletableFuture().cancel(false);
    } catch (RuntimeException e) {
      // The job is being stopped: that goes on.
      troubles.accept(e);
    }
  }

  /**
   * Lets the component do its part. The recorded result is there at once, but what the component
   * did before it gave one, and later calls rely on, it does anew.
   */
  private static void catchUp(CompletionStage<?> stage) {
    CountDownLatch done = new CountDownLatch(1);
    stage.whenComplete((result, thrown) -> done.countDown());
    try {
      // Who answered then may be away now; the recorded result counts in any case.
      done.await(PATIENCE, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Delivers the outcome. If the kernel thread completes the wait, a recorded message has caused
   * that. If the result was there before the wait began, its time is unknown, so it is posted as a
   * message.
   */
  private void complete(@Nullable Object result, @Nullable Throwable thrown) {
    if (scheduler.isKernelThread() && waiting) {
      own = result;
      answer.arrived(thrown == null ? Outcome.value(null) : new Outcome.Failure(thrown));
    } else {
      answer.post(ComponentResult.of(result, thrown));
    }
  }
}

package org.urbi.kernel.uobject;

import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.PendingAnswer;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.message.Outcome;
import org.urbi.kernel.node.Frame;
import urbi.UCallback;

/**
 * A call that runs on a thread of its own while the job waits and others go on. If the job is
 * stopped, it no longer waits, but the thread continues to the end of the function.
 */
final class ThreadedCall {
  private ThreadedCall() {}

  /**
   * Calls the function, and waits for its end.
   *
   * @return null if the call was dropped because too many wait
   * @throws Throwable what the function throws
   */
  static @Nullable Object await(
      PluggedContext context, Frame caller, UCallback callback, Object[] arguments)
      throws Throwable {
    PendingAnswer answer = new PendingAnswer(caller.job(), Wait.COMPONENT);
    Runnable call = () -> run(answer, callback, arguments);
    if (!caller.job().scheduler().time().attempt(() -> callback.execute(context, call))) {
      answer.arrived(Outcome.value(null));
      return null;
    }
    return switch (answer.await()) {
      case Outcome.Value value -> value.data().value();
      case Outcome.Failure failure -> throw thrown(failure.thrown());
    };
  }

  private static Throwable thrown(Throwable failure) {
    return failure instanceof PropagatedUrbiException
            || failure instanceof KernelRefusal
            || failure instanceof CompletionException
        ? failure
        : new IllegalStateException(
            Problem.CAUGHT_IN_THREAD.text(JavaFailures.text(failure)), failure);
  }

  private static void run(PendingAnswer answer, UCallback callback, Object[] arguments) {
    Object result;
    try {
      result = callback.call(arguments);
    } catch (Throwable e) {
      answer.post(new Outcome.Failure(e));
      return;
    }
    if (result instanceof CompletionStage<?> stage) {
      stage.whenComplete((value, failure) ->
          answer.post(
              ComponentResult.of(
                  value, failure == null ? null : new CompletionException(failure))));
    } else {
      answer.post(ComponentResult.of(result, null));
    }
  }
}

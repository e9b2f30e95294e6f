package org.urbi.kernel.uobject;

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
    Runnable call = () -> answer.post(run(callback, arguments));
    if (!caller.job().scheduler().attempt(() -> callback.execute(context, call))) {
      answer.arrived(new Outcome(null, null));
      return null;
    }
    Outcome outcome = answer.await();
    Throwable failure = outcome.failure();
    if (failure == null) {
      return outcome.value();
    }
    throw failure instanceof PropagatedUrbiException || failure instanceof KernelRefusal
        ? failure
        : new IllegalStateException(
            Problem.CAUGHT_IN_THREAD.text(JavaFailures.text(failure)), failure);
  }

  private static Outcome run(UCallback callback, Object[] arguments) {
    try {
      return new Outcome(callback.call(arguments), null);
    } catch (Throwable e) {
      return new Outcome(null, e);
    }
  }
}

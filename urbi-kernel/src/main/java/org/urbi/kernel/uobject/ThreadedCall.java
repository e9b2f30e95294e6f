package org.urbi.kernel.uobject;

import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.node.Frame;
import urbi.UCallback;

/**
 * A call that runs on a thread of its own while the job waits and others go on. A job that is
 * stopped waits no longer; the thread goes on to the end of the function.
 */
final class ThreadedCall {
  private final UCallback callback;
  private final Object[] arguments;
  private final Job job;
  private Object result;
  private Throwable failure;
  private boolean done;
  private boolean abandoned;

  private ThreadedCall(UCallback callback, Object[] arguments, Job job) {
    this.callback = callback;
    this.arguments = arguments;
    this.job = job;
  }

  /**
   * Calls the function, and waits for its end.
   *
   * @return null if the call was dropped because too many wait
   * @throws Throwable what the function throws
   */
  static Object await(PluggedContext context, Frame caller, UCallback callback, Object[] arguments)
      throws Throwable {
    ThreadedCall call = new ThreadedCall(callback, arguments, caller.job());
    Scheduler scheduler = caller.job().scheduler();
    if (!callback.execute(context, () -> call.run(scheduler))) {
      return null;
    }
    scheduler.pace().begin();
    try {
      while (!call.done) {
        call.job.waitForWake();
      }
    } finally {
      call.abandoned = true;
    }
    if (call.failure != null) {
      throw call.failure;
    }
    return call.result;
  }

  private void run(Scheduler scheduler) {
    try {
      result = callback.call(arguments);
    } catch (Throwable e) {
      failure = e;
    } finally {
      scheduler
          .inbox()
          .post(() -> {
            scheduler.pace().end();
            done = true;
            if (!abandoned) {
              job.wake();
            }
          });
    }
  }
}

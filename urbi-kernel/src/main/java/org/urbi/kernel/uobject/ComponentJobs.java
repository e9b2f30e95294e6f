package org.urbi.kernel.uobject;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.FrameLayout;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import urbi.UCallback;

/** The jobs in which components are called, and what they wait for; on the kernel thread. */
final class ComponentJobs {
  private final PluggedContext context;
  private final Interpreter interpreter;
  private final Scheduler scheduler;

  ComponentJobs(PluggedContext context) {
    this.context = context;
    interpreter = context.interpreter();
    scheduler = interpreter.scheduler();
  }

  /** A task for a job. */
  @FunctionalInterface
  interface FrameTask {
    void run(Frame frame);
  }

  /** Starts a job of no connection. */
  void start(FrameTask task) {
    UrbiLobby lobby = context.lobby();
    scheduler.startDetached(
        lobby,
        scheduler.rootScope(),
        "uobject",
        job -> task.run(Frame.top(interpreter, job, lobby, new FrameLayout())));
  }

  /** Calls a function in a job, and reports what it throws. */
  void callBack(Job job, UrbiObject lobby, UCallback callback) {
    Frame frame = Frame.top(interpreter, job, lobby, new FrameLayout());
    CallStatistics.Entry entry = context.statistics().entry(callback.name());
    long started = entry.begin();
    Frame outer = context.crossing().leave(frame, callback.name());
    try {
      callback.call();
    } catch (ControlFlowException e) {
      throw e;
    } catch (Throwable e) {
      report(job, callback.name(), e);
    } finally {
      entry.end(started);
      context.crossing().back(frame, outer);
    }
  }

  private void report(Job job, String function, Throwable e) {
    RuntimeException shown =
        e instanceof PropagatedUrbiException raised
            ? raised.original()
            : interpreter
                .errors()
                .primitive(
                    Utf8Text.toUrbi(function),
                    Problem.REASON,
                    Utf8Text.toUrbi(JavaFailures.caught(JavaFailures.calling(function), e)));
    interpreter.report(job, shown);
  }

  /** Runs a threaded call for whose result nobody waits. */
  void runThreaded(UCallback callback, Runnable call) {
    boolean started =
        scheduler
            .time()
            .attempt(() ->
                callback.execute(
                    context,
                    () -> {
                      try {
                        call.run();
                      } finally {
                        scheduler.inbox().post(new Message.ComponentDone());
                      }
                    }));
    if (started) {
      scheduler.pace().begin();
    }
  }

  /** Waits for a result while other jobs run, and cancels it if the job is stopped. */
  @Nullable Object await(Frame frame, CompletionStage<?> stage) {
    return new AwaitedResult(frame.job())
        .await(stage, e -> context.report(JavaFailures.caught(JavaFailures.calling("cancel"), e)));
  }

  /**
   * Makes a job wait until a stage is complete, normally or not. After the time limit the stage is
   * cancelled.
   */
  @Nullable Void awaitEnd(Frame frame, CompletableFuture<?> stage, Duration most) {
    Timers.Timer limit =
        scheduler.timers().add(scheduler.deadline(most.toNanos()), () -> stage.cancel(false));
    try {
      return awaitEnd(frame, stage);
    } finally {
      limit.cancel();
    }
  }

  /** Makes a job wait until a stage is complete, normally or not. */
  @Nullable Void awaitEnd(Frame frame, CompletableFuture<?> stage) {
    try {
      new AwaitedResult(frame.job()).await(stage);
    } catch (CompletionException e) {
      // The reason is reported elsewhere, by whoever completes the stage.
    }
    return null;
  }
}

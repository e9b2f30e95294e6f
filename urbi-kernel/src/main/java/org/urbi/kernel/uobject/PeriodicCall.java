package org.urbi.kernel.uobject;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.object.UrbiObject;
import urbi.UCallback;

/** Calls a function of a UObject or a hub periodically (manual, "Timers"). */
final class PeriodicCall {
  private final PluggedContext context;
  private final Scheduler scheduler;
  private final UrbiObject lobby;
  private final UCallback callback;
  private final double milliseconds;
  private final boolean afterPass;
  private Timers.@Nullable Timer timer;
  private long deadline;
  private boolean calling;
  private boolean ended;

  /**
   * @param afterPass whether to call after the jobs of a tick, or before
   */
  PeriodicCall(
      PluggedContext context,
      UrbiObject lobby,
      UCallback callback,
      double milliseconds,
      boolean afterPass) {
    this.context = context;
    this.scheduler = context.interpreter().scheduler();
    this.lobby = lobby;
    this.callback = callback;
    this.milliseconds = milliseconds;
    this.afterPass = afterPass;
  }

  /** Begins; on the kernel thread. */
  void begin() {
    deadline = scheduler.now();
    next();
  }

  private void next() {
    long period = context.periods().period(milliseconds);
    deadline = Math.max(deadline + period, scheduler.now());
    timer = scheduler.timers().add(deadline, this::due);
  }

  private void due() {
    if (ended) {
      return;
    }
    next();
    if (calling) {
      return;
    }
    calling = true;
    Job job =
        afterPass
            ? scheduler.startBehind(lobby, scheduler.rootScope(), "update", this::call)
            : scheduler.startAhead(lobby, scheduler.rootScope(), "timer", this::call);
    job.onEnd(() -> calling = false);
  }

  private void call(Job job) {
    if (!ended) {
      context.jobs().callBack(job, lobby, callback);
    }
  }

  /** Ends; on the kernel thread. */
  void end() {
    ended = true;
    if (timer != null) {
      timer.cancel();
    }
  }
}

package org.urbi.kernel;

import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.HoldWatchdog;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.journal.StopReason;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.outside.HeapUsage;

/** Ends jobs that hold the kernel for too long, or fill its memory, without letting others run. */
final class HoldLimit {
  private final Errors errors;
  private final KernelLog log;

  private HoldLimit(Errors errors, KernelLog log) {
    this.errors = errors;
    this.log = log;
  }

  /**
   * Sets the limit of a kernel that has been started.
   *
   * @param limit zero for none
   * @return the watchdog, which watches budgets, too; null in a replay
   */
  static @Nullable HoldWatchdog set(
      Scheduler scheduler, Errors errors, KernelLog log, Duration limit) {
    HoldLimit holding = new HoldLimit(errors, log);
    // A replay may have no limit where the recorded run had one and reached it.
    scheduler.interruptions().setLimitFailure(holding::failure);
    if (scheduler.journal().isReplay()) {
      return null;
    }
    long most = limit.isZero() ? Long.MAX_VALUE : limit.toNanos();
    return HoldWatchdog.watch(scheduler, most, HeapUsage::free, HeapUsage.all(), holding::tell);
  }

  private UrbiException failure(Job job, StopReason why) {
    if (why == StopReason.GREEDY) {
      long most = job.budget().limit(Resource.MEMORY);
      return most == Budget.UNLIMITED
          ? errors.limit(Problem.MEMORY_EXHAUSTED)
          : errors.limit(Problem.BUDGET_EXHAUSTED, most, Resource.MEMORY.unit());
    }
    return errors.limit(Problem.HELD_TOO_LONG, described(job, job.component()));
  }

  /** Called on the watchdog's thread, so it reads nothing but names. */
  private void tell(Job job, @Nullable String component, StopReason why, long limit) {
    if (log.shows(LogLevel.LOG)) {
      String who = described(job, component);
      log.write(
          "urbi: "
              + (why == StopReason.GREEDY
                  ? Problem.FILLS_MEMORY.text(who, limit)
                  : Problem.HOLDS_KERNEL.text(who, limit / 1_000_000 / 1000.0)));
    }
  }

  /** The job, its client and its component, for people. */
  static String described(Job job, @Nullable String component) {
    String text = "job " + job.name();
    if (job.lobby() instanceof UrbiLobby lobby && lobby.isInstance()) {
      text += " of " + lobby.description();
    }
    return component == null ? text : text + ", in " + component + ",";
  }
}

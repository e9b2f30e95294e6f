package org.urbi.kernel.job;

import java.util.PriorityQueue;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;

/** Actions to run at given times: ordered by deadline, then by the order of the requests. */
public final class Timers {
  private final PriorityQueue<Timer> queue = new PriorityQueue<>();
  private final Supplier<Budget> admission;
  private long sequence;
  private int cancelled;

  /**
   * @param admission takes a timer from a budget and returns that budget, or throws if there are
   *     too many
   */
  Timers(Supplier<Budget> admission) {
    this.admission = admission;
  }

  /** An action that runs once. */
  public final class Timer implements Comparable<Timer> {
    private final long deadline;
    private final long order;
    private final @Nullable Budget budget;
    private @Nullable Runnable action;

    private Timer(long deadline, long order, @Nullable Budget budget, Runnable action) {
      this.deadline = deadline;
      this.order = order;
      this.budget = budget;
      this.action = action;
    }

    public long deadline() {
      return deadline;
    }

    /** Cancels the action. */
    public void cancel() {
      if (action != null) {
        end();
        // Cancelled timers stay in the queue until their deadline, unless they are the larger part
        // of it.
        if (++cancelled > 64 && cancelled > queue.size() / 2) {
          queue.removeIf(timer -> timer.action == null);
          cancelled = 0;
        }
      }
    }

    private void end() {
      action = null;
      if (budget != null) {
        budget.giveBack(Resource.TIMERS);
      }
    }

    @Override
    public int compareTo(Timer other) {
      int byDeadline = Long.compare(deadline, other.deadline);
      return byDeadline != 0 ? byDeadline : Long.compare(order, other.order);
    }
  }

  /**
   * Runs an action at that time of the scheduler.
   *
   * @throws RuntimeException if the running job may have no more timers
   */
  public Timer add(long deadline, Runnable action) {
    return add(deadline, admission.get(), action);
  }

  /**
   * The same for a sleeping job, which is not counted as a timer because it is counted as a job.
   */
  Timer addUncounted(long deadline, Runnable action) {
    return add(deadline, null, action);
  }

  private Timer add(long deadline, @Nullable Budget budget, Runnable action) {
    Timer timer = new Timer(deadline, sequence++, budget, action);
    queue.add(timer);
    return timer;
  }

  /**
   * Replaces the timer of a sleeping job; among timers with the same deadline it keeps the rank of
   * the old one.
   */
  Timer moved(Timer before, long deadline, Runnable action) {
    Timer timer = new Timer(deadline, before.order, null, action);
    queue.add(timer);
    return timer;
  }

  /** Runs the actions that are due. */
  void fire(long now) {
    Timer first;
    while ((first = queue.peek()) != null && first.deadline <= now) {
      queue.poll();
      Runnable action = first.action;
      if (action == null) {
        cancelled = Math.max(0, cancelled - 1);
      } else {
        first.end();
        action.run();
      }
    }
  }

  /** The deadline of the next action, or {@link Long#MAX_VALUE}. */
  long next() {
    Timer first;
    while ((first = queue.peek()) != null && first.action == null) {
      queue.poll();
      cancelled = Math.max(0, cancelled - 1);
    }
    return first == null ? Long.MAX_VALUE : first.deadline;
  }
}

package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.List;
import java.util.PriorityQueue;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;

/**
 * Actions to run at given times: ordered by deadline, then by the order of the requests.
 *
 * <p>A hundred thousand jobs that fall asleep together wake up together. Timers that are requested
 * one after the other for the same time form a row, and only the first of each is in the queue.
 */
public final class Timers {
  private final PriorityQueue<Timer> queue = new PriorityQueue<>();

  /** The one requested last, unless it is over. */
  private @Nullable Timer latest;

  private final Supplier<Budget> admission;
  private long sequence;
  private int size;
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

    /** The next one of its row. */
    private @Nullable Timer after;

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
        // Cancelled timers stay until their deadline, unless they are the larger part of all.
        if (++cancelled > 64 && cancelled > size / 2) {
          dropCancelled();
        }
      }
    }

    private void end() {
      action = null;
      if (latest == this) {
        latest = null;
      }
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
    if (latest != null && latest.deadline == deadline) {
      latest.after = timer;
    } else {
      queue.add(timer);
    }
    latest = timer;
    size++;
    return timer;
  }

  /**
   * Replaces the timer of a sleeping job; among timers with the same deadline it keeps the rank of
   * the old one.
   */
  Timer moved(Timer before, long deadline, Runnable action) {
    Timer timer = new Timer(deadline, before.order, null, action);
    queue.add(timer);
    size++;
    return timer;
  }

  /** Runs the actions that are due. */
  void fire(long now) {
    Timer first;
    while ((first = queue.peek()) != null && first.deadline <= now) {
      Runnable action = first.action;
      takeOut(first);
      if (action != null) {
        first.end();
        action.run();
      }
    }
  }

  /** The deadline of the next action, or {@link Long#MAX_VALUE}. */
  long next() {
    Timer first;
    while ((first = queue.peek()) != null && first.action == null) {
      takeOut(first);
    }
    return first == null ? Long.MAX_VALUE : first.deadline;
  }

  /** The first one of all leaves; the next one of its row takes its place. */
  private void takeOut(Timer first) {
    queue.poll();
    Timer next = first.after;
    if (next != null) {
      first.after = null;
      queue.add(next);
    }
    size--;
    if (first.action == null) {
      cancelled--;
    }
  }

  private void dropCancelled() {
    List<Timer> rows;
    try {
      rows = new ArrayList<>(queue);
    } catch (OutOfMemoryError e) {
      // Whoever is being ended to free memory must not be kept by the want of it.
      return;
    }
    queue.clear();
    for (Timer row : rows) {
      Timer first = withoutCancelled(row);
      if (first != null) {
        queue.add(first);
      }
    }
    size -= cancelled;
    cancelled = 0;
  }

  /** The first one of what remains of a row; null if nothing does. */
  private static @Nullable Timer withoutCancelled(Timer row) {
    Timer first = null;
    Timer last = null;
    for (Timer timer = row; timer != null; timer = timer.after) {
      if (timer.action != null) {
        if (last == null) {
          first = timer;
        } else {
          last.after = timer;
        }
        last = timer;
      }
    }
    if (last != null) {
      last.after = null;
    }
    return first;
  }
}

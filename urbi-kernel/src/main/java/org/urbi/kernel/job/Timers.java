package org.urbi.kernel.job;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;

/**
 * Actions to run at given times: ordered by deadline, then by the order of the requests.
 *
 * <p>A hundred thousand jobs that fall asleep together wake up together. Timers that a lobby
 * requests one after the other for the same time form a row, and only the first of each is in a
 * queue. Each budget, which is that of a lobby, has a {@linkplain Line line} of its own: so the
 * timers of one can run although those of another, which are due before, are too many for a tick.
 */
public final class Timers {
  /** So many actions run in a tick in their order; then each line has its part of as many. */
  static final int MOST_IN_TICK = 500;

  /** The lines of budgets that still exist. */
  private final Map<Budget, Line> lines = new WeakHashMap<>();

  /** The first timer of each line that is not empty; some others that were first once. */
  private final PriorityQueue<Timer> firsts = new PriorityQueue<>();

  private final Supplier<Budget> admission;
  private long sequence;

  /**
   * @param admission takes a timer from a budget and returns that budget, or throws if there are
   *     too many
   */
  Timers(Supplier<Budget> admission) {
    this.admission = admission;
  }

  /** An action that runs once. */
  public static final class Timer implements Comparable<Timer> {
    private final Line line;
    private final long deadline;
    private final long order;
    private final @Nullable Budget budget;
    private @Nullable Runnable action;

    /** The next one of its row. */
    private @Nullable Timer after;

    /** Whether it is in {@link Timers#firsts}. */
    private boolean listed;

    private Timer(Line line, long deadline, long order, @Nullable Budget budget, Runnable action) {
      this.line = line;
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
        line.countCancelled();
      }
    }

    private void end() {
      action = null;
      if (line.latest == this) {
        line.latest = null;
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

  /** The timers of one budget. */
  private final class Line {
    private final PriorityQueue<Timer> rows = new PriorityQueue<>();

    /** The one requested last, unless it is over. */
    private @Nullable Timer latest;

    private int size;
    private int cancelled;

    void add(Timer timer) {
      if (latest != null && latest.deadline == timer.deadline) {
        latest.after = timer;
      } else {
        addRow(timer);
      }
      latest = timer;
      size++;
    }

    private void addRow(Timer row) {
      rows.add(row);
      try {
        list();
      } catch (OutOfMemoryError e) {
        rows.remove(row);
        throw e;
      }
    }

    /** Adds one that has a rank already. */
    void addRanked(Timer timer) {
      addRow(timer);
      size++;
    }

    /** The first one is where the first ones of all are looked for. */
    void list() {
      Timer first = rows.peek();
      if (first != null && !first.listed) {
        firsts.add(first);
        first.listed = true;
      }
    }

    /** The first one leaves; the next one of its row takes its place. */
    void takeOut() {
      Timer first = requireNonNull(rows.poll(), "a line in which one is first");
      Timer next = first.after;
      if (next != null) {
        first.after = null;
        rows.add(next);
      }
      size--;
      if (first.action == null) {
        cancelled--;
      }
    }

    /** One that has been first has ended; if it still is, the next one takes its place. */
    void forget(Timer ended) {
      if (rows.peek() == ended) {
        takeOut();
        list();
      }
    }

    /** Takes the first one out, and runs its action. */
    void fire(Timer first) {
      Runnable action = first.action;
      takeOut();
      if (action != null) {
        first.end();
        action.run();
      }
    }

    /** Takes out the timers that are due, up to that many, and runs their actions. */
    void fire(long now, int most) {
      for (int i = 0; i < most; i++) {
        Timer first = rows.peek();
        if (first == null || first.deadline > now) {
          return;
        }
        fire(first);
      }
    }

    /** Cancelled timers stay until their deadline, unless they are the larger part of all. */
    void countCancelled() {
      if (++cancelled > 64 && cancelled > size / 2) {
        dropCancelled();
      }
    }

    private void dropCancelled() {
      List<Timer> all;
      try {
        all = new ArrayList<>(rows);
        firsts.removeIf(timer -> timer.line == this && timer.action == null);
      } catch (OutOfMemoryError e) {
        // Whoever is being ended to free memory must not be kept by the want of it.
        return;
      }
      rows.clear();
      for (Timer row : all) {
        Timer first = withoutCancelled(row);
        if (first != null) {
          rows.add(first);
        }
      }
      list();
      size -= cancelled;
      cancelled = 0;
    }
  }

  /**
   * Runs an action at that time of the scheduler.
   *
   * @throws RuntimeException if the running job may have no more timers
   */
  public Timer add(long deadline, Runnable action) {
    Budget budget = admission.get();
    return add(deadline, budget.account(), budget, action);
  }

  /**
   * Wakes a sleeping job at that time; it is not counted as a timer, because the job is counted.
   */
  Timer addUncounted(long deadline, Budget account, Runnable action) {
    return add(deadline, account, null, action);
  }

  private Timer add(long deadline, Budget account, @Nullable Budget budget, Runnable action) {
    Line line = lines.computeIfAbsent(account, known -> new Line());
    Timer timer = new Timer(line, deadline, sequence++, budget, action);
    line.add(timer);
    return timer;
  }

  /**
   * Replaces the timer of a sleeping job; among timers with the same deadline it keeps the rank of
   * the old one.
   */
  Timer moved(Timer before, long deadline, Runnable action) {
    Timer timer = new Timer(before.line, deadline, before.order, null, action);
    before.line.addRanked(timer);
    return timer;
  }

  /** Runs the actions that are due. */
  void fire(long now) {
    fireInOrder(now, Integer.MAX_VALUE);
  }

  /**
   * Runs those of the actions that are due for which a tick has time: others wait, too. The rest is
   * due in the next tick. What runs depends on nothing but the order of the timers, so that a
   * recorded run can be replayed.
   */
  void fireSome(long now) {
    fireInOrder(now, MOST_IN_TICK);
    if (!isDue(now)) {
      return;
    }
    Set<Line> due = new LinkedHashSet<>();
    while (isDue(now)) {
      due.add(unlistFirst().line);
    }
    int most = Math.max(1, MOST_IN_TICK / due.size());
    try {
      due.forEach(line -> line.fire(now, most));
    } finally {
      due.forEach(Line::list);
    }
  }

  private void fireInOrder(long now, int most) {
    for (int i = 0; i < most && isDue(now); i++) {
      Timer first = unlistFirst();
      try {
        first.line.fire(first);
      } finally {
        first.line.list();
      }
    }
  }

  private boolean isDue(long now) {
    return next() <= now && !firsts.isEmpty();
  }

  /** The deadline of the next action, or {@link Long#MAX_VALUE}. */
  long next() {
    Timer first;
    while ((first = firsts.peek()) != null && first.action == null) {
      first.line.forget(unlistFirst());
    }
    return first == null ? Long.MAX_VALUE : first.deadline;
  }

  /** The first one of all; it is that of its line, too, if those of all lines are listed. */
  private Timer unlistFirst() {
    Timer first = firsts.remove();
    first.listed = false;
    return first;
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

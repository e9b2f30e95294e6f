package org.urbi.kernel.job;

import java.util.PriorityQueue;

/** What is to be done at a given time: first deadline first, then in the order of the requests. */
public final class Timers {
  private final PriorityQueue<Timer> queue = new PriorityQueue<>();
  private long sequence;
  private int cancelled;

  /** Something to be done once. */
  public final class Timer implements Comparable<Timer> {
    private final long deadline;
    private final long order;
    private Runnable action;

    private Timer(long deadline, long order, Runnable action) {
      this.deadline = deadline;
      this.order = order;
      this.action = action;
    }

    public long deadline() {
      return deadline;
    }

    /** It will not be done. */
    public void cancel() {
      if (action != null) {
        action = null;
        // Cancelled timers leave with their deadline, unless they are most of the queue.
        if (++cancelled > 64 && cancelled > queue.size() / 2) {
          queue.removeIf(timer -> timer.action == null);
          cancelled = 0;
        }
      }
    }

    @Override
    public int compareTo(Timer other) {
      int byDeadline = Long.compare(deadline, other.deadline);
      return byDeadline != 0 ? byDeadline : Long.compare(order, other.order);
    }
  }

  /** Does something at that time of the scheduler. */
  public Timer add(long deadline, Runnable action) {
    Timer timer = new Timer(deadline, sequence++, action);
    queue.add(timer);
    return timer;
  }

  /** A timer in the place of another one, of which it keeps the rank among those at its time. */
  Timer moved(Timer before, long deadline, Runnable action) {
    Timer timer = new Timer(deadline, before.order, action);
    queue.add(timer);
    return timer;
  }

  /** Does what is due. */
  void fire(long now) {
    Timer first;
    while ((first = queue.peek()) != null && first.deadline <= now) {
      queue.poll();
      Runnable action = first.action;
      if (action == null) {
        cancelled = Math.max(0, cancelled - 1);
      } else {
        first.action = null;
        action.run();
      }
    }
  }

  /** The time of the next thing to do, or {@link Long#MAX_VALUE}. */
  long next() {
    Timer first;
    while ((first = queue.peek()) != null && first.action == null) {
      queue.poll();
      cancelled = Math.max(0, cancelled - 1);
    }
    return first == null ? Long.MAX_VALUE : first.deadline;
  }
}

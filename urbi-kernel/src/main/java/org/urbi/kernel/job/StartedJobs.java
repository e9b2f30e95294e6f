package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;

/**
 * The jobs that have been started and wait for a place in the queue. One that was started by
 * another job runs right behind it in the same tick, unless there are too many such.
 */
final class StartedJobs {
  /** The limit of jobs that start and run in one tick: they must not starve the others. */
  private static final int BIRTHS_PER_TICK = 100_000;

  /** The limit of jobs started by jobs that are new in that tick: the chain may be endless. */
  private static final int DESCENDANTS_PER_TICK = 1000;

  private final RunQueue queue;
  private final JobList ahead = new JobList();
  private final JobList behind = new JobList();
  private final JobList born = new JobList();
  private int births;
  private int descendants;

  /** Whether some of those that the running job has started are of another lobby. */
  private boolean strangers;

  StartedJobs(RunQueue queue) {
    this.queue = queue;
  }

  boolean isEmpty() {
    return born.isEmpty() && ahead.isEmpty() && behind.isEmpty();
  }

  /** Adds a job that another one, which is running, or nobody has started. */
  void add(Job job, @Nullable Job running) {
    if (running == null || births >= BIRTHS_PER_TICK || descendants >= DESCENDANTS_PER_TICK) {
      queue.add(job);
    } else {
      births++;
      if (queue.isFresh()) {
        descendants++;
      }
      born.add(job.turn);
      strangers |= job.account() != running.account();
    }
  }

  /** Adds a job that runs first in the next tick. */
  void addAhead(Job job) {
    ahead.add(job.turn);
  }

  /** Adds a job that runs after all others have had their turn. */
  void addBehind(Job job) {
    behind.add(job.turn);
  }

  /** A tick begins: the jobs that are to run first go to the front of the queue. */
  void joinAhead() {
    for (Job job = ahead.poll(); job != null; job = ahead.poll()) {
      queue.addFirst(job);
    }
  }

  void beginRound() {
    births = 0;
    descendants = 0;
  }

  /**
   * Those that the running job has started run next, in this round, unless they {@linkplain
   * #joinElsewhere wait}; in the order in which it has started them.
   */
  void joinRound() {
    if (strangers) {
      strangers = false;
      joinElsewhere();
    }
    for (Job child = born.pollLast(); child != null; child = born.pollLast()) {
      queue.addToRound(child);
    }
  }

  /** In a rush those of other lobbies wait behind others, also in their order. */
  private void joinElsewhere() {
    for (int left = queue.isRushing() ? born.size() : 0; left > 0; left--) {
      Job child = born.poll();
      if (child != null && !queue.addElsewhere(child)) {
        born.add(child.turn);
      }
    }
  }

  /** The round is over: those that were started since then run in the next one. */
  void joinQueue() {
    for (Job child = born.poll(); child != null; child = born.poll()) {
      queue.add(child);
    }
  }

  /** How many jobs run after the others. */
  int behind() {
    return behind.size();
  }

  /** The first job of those that run after the others; null if there is none. */
  @Nullable Job pollBehind() {
    return behind.poll();
  }
}

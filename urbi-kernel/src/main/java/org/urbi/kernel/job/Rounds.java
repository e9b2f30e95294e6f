package org.urbi.kernel.job;

import org.jspecify.annotations.Nullable;

/**
 * The turns of the jobs within a tick: first of all that can run, then of those that run behind
 * them. How far it has got is kept here, for the thread that goes on if the one that has begun is
 * kept by a job.
 */
final class Rounds {
  private enum Stage {
    /** No tick has begun. */
    NONE,
    /** All jobs that can run have their turns. */
    ALL,
    /** The jobs that run behind all others have their turns. */
    BEHIND
  }

  private final Scheduler scheduler;
  private final RunQueue runnable;
  private final StartedJobs started;
  private Stage stage = Stage.NONE;

  /** How many of the jobs that run behind all others are left. */
  private int behind;

  Rounds(Scheduler scheduler, RunQueue runnable, StartedJobs started) {
    this.scheduler = scheduler;
    this.runnable = runnable;
    this.started = started;
  }

  /** Whether the rounds of a tick have begun, and not ended. */
  boolean areUnderWay() {
    return stage != Stage.NONE;
  }

  /**
   * Begins the rounds of a tick.
   *
   * @param now what the clock says
   */
  void begin(long now) {
    stage = Stage.ALL;
    started.beginRound();
    runnable.beginRound(now);
  }

  /** Gives the rounds of this tick up: jobs that are left have their turns in the next one. */
  void giveUp() {
    stage = Stage.NONE;
  }

  /** Runs the rounds of this tick, or goes on with them. */
  void run() {
    if (stage == Stage.ALL) {
      runAll(false);
      behind = started.behind();
      stage = Stage.BEHIND;
    }
    runBehind();
    stage = Stage.NONE;
  }

  /** Runs each job once that can run, although the loop has been stopped. */
  void runLast() {
    started.beginRound();
    runnable.beginWholeRound();
    runAll(true);
  }

  private void runAll(boolean last) {
    started.joinRound();
    Job job;
    while ((last || !scheduler.isStopped()) && (job = runnable.next()) != null) {
      runTurn(job);
      started.joinRound();
    }
    scheduler.endTurn();
    scheduler.beginTurn();
  }

  private void runBehind() {
    started.joinQueue();
    for (Job job = nextBehind(); job != null; job = nextBehind()) {
      runTurn(job);
      started.joinQueue();
    }
    scheduler.endTurn();
  }

  private @Nullable Job nextBehind() {
    if (behind == 0 || scheduler.isStopped()) {
      return null;
    }
    behind--;
    return started.pollBehind();
  }

  private void runTurn(Job job) {
    scheduler.beginTurnOf(job);
    job.resume();
  }
}

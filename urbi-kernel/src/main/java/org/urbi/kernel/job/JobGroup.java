package org.urbi.kernel.job;

import static java.util.Objects.requireNonNull;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;

/**
 * The jobs that a job starts and waits for: the operands of {@code &}, the statements that {@code
 * ,} sends to the background of a scope. When an exception (or {@code return}, or {@code break})
 * leaves one of them, it also leaves the code that started it, and the others end.
 */
public final class JobGroup {
  /** To start very many takes long, so after each such crowd others have their turns. */
  private static final int CROWD = 10_000;

  private final Job parent;
  private final JobList live = new JobList();
  private int started;
  private boolean left;
  private @Nullable Throwable failure;

  public JobGroup(Job parent) {
    this.parent = parent;
  }

  /**
   * Starts a job under the tags of the parent; it runs when its turn comes.
   *
   * @throws RuntimeException the exception that has left one of those before
   */
  public Job start(Job.Body body) {
    if (started == CROWD) {
      started = 0;
      letOthersRun();
    }
    started++;
    Job job = parent.scheduler().start(parent, this, body);
    live.add(linkOf(job));
    return job;
  }

  private void letOthersRun() {
    try {
      parent.yield();
    } catch (RuntimeException e) {
      throw translate(e);
    }
  }

  private static JobList.Link linkOf(Job child) {
    return requireNonNull(child.grouped, "it was started in a group");
  }

  void childEnded(Job child, @Nullable Throwable thrown) {
    linkOf(child).leave();
    if (left) {
      return;
    }
    if (thrown != null && failure == null) {
      failure = thrown;
      parent.inject(new ChildFailure(this, thrown));
      // Stop the others now: they must not run on until the parent's next turn.
      endLive();
    } else if (live.isEmpty()) {
      parent.wake();
    }
  }

  /**
   * Waits for all the jobs.
   *
   * @throws RuntimeException the exception that has left one of them
   */
  public void join() {
    if (!live.isEmpty() && failure == null && parent.nonInterruptible() > 0) {
      throw parent.scheduler().refusal(Problem.DEPENDS_UNINTERRUPTIBLE);
    }
    while (!live.isEmpty() && failure == null) {
      parent.waitForWake(Wait.JOBS);
    }
    if (failure != null) {
      throw rethrown(failure);
    }
  }

  /** The exception to rethrow instead of one that was caught while the group was running. */
  public RuntimeException translate(RuntimeException caught) {
    return caught instanceof ChildFailure report && report.group() == this
        ? rethrown(report.failure())
        : caught;
  }

  private static RuntimeException rethrown(Throwable failure) {
    if (failure instanceof Error error) {
      throw error;
    }
    return (RuntimeException) failure;
  }

  /** Ends the remaining jobs of the group; must always be called. */
  public void leave() {
    left = true;
    parent.forget(this);
    endLive();
  }

  private void endLive() {
    if (!live.isEmpty()) {
      parent.scheduler().stops().begin(new StopOfGroup(this, live));
    }
  }
}

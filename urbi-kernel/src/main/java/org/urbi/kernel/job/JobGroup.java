package org.urbi.kernel.job;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;

/**
 * The jobs that a job starts and waits for: the operands of {@code &}, the statements that {@code
 * ,} sends to the background of a scope. When one of them is left by an exception (or {@code
 * return}, or {@code break}), so is the code which started it, and the others end.
 */
public final class JobGroup {
  private final Job parent;
  private final Set<Job> live = new LinkedHashSet<>();
  private boolean left;
  private @Nullable Throwable failure;

  public JobGroup(Job parent) {
    this.parent = parent;
  }

  /** Starts a job under the tags of the parent; it runs when its turn comes. */
  public Job start(Job.Body body) {
    Job job = parent.scheduler().start(parent, this, body);
    live.add(job);
    return job;
  }

  void childEnded(Job child, @Nullable Throwable thrown) {
    live.remove(child);
    if (left) {
      return;
    }
    if (thrown != null && failure == null) {
      failure = thrown;
      parent.inject(new ChildFailure(this, thrown));
      // The others do not run on until it is the parent's turn.
      for (Job job : new ArrayList<>(live)) {
        job.terminate();
      }
    } else if (live.isEmpty()) {
      parent.wake();
    }
  }

  /**
   * Waits for all the jobs.
   *
   * @throws RuntimeException what one of them was left by
   */
  public void join() {
    if (!live.isEmpty() && failure == null && parent.nonInterruptible() > 0) {
      throw parent.scheduler().refusal(Problem.DEPENDS_UNINTERRUPTIBLE);
    }
    while (!live.isEmpty() && failure == null) {
      parent.waitForWake();
    }
    if (failure != null) {
      throw rethrown(failure);
    }
  }

  /** What to throw on in the place of what was caught while the group was running. */
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

  /** Ends what is left of the group; to be called in any case. */
  public void leave() {
    left = true;
    parent.forget(this);
    if (!live.isEmpty()) {
      for (Job job : new ArrayList<>(live)) {
        job.terminate();
      }
    }
  }
}

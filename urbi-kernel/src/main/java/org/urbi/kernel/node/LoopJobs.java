package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.TagState;

/**
 * The jobs that the code of a loop has detached: {@code break} ends them like everything else in
 * the loop (manual, "Control", {@code detach}).
 */
public final class LoopJobs {
  private final @Nullable LoopJobs outer;
  private @Nullable TagScope scope;

  private LoopJobs(@Nullable LoopJobs outer) {
    this.outer = outer;
  }

  /** A loop begins. */
  static LoopJobs begin(Frame frame) {
    LoopJobs jobs = new LoopJobs(frame.loopJobs);
    frame.loopJobs = jobs;
    return jobs;
  }

  /** The loop is over. */
  void end(Frame frame, boolean broken) {
    frame.loopJobs = outer;
    if (scope != null) {
      if (broken) {
        scope.tag().stop(frame.job.scheduler(), frame.interpreter.values().voidObject);
      }
      scope.end();
    }
  }

  /** The scope for a job that the code of an activation detaches. */
  public static TagScope scope(Frame frame) {
    return frame.loopJobs == null ? frame.job.scopeForNew() : frame.loopJobs.scope(frame.job);
  }

  private TagScope scope(Job job) {
    if (scope != null && scope.isAbandoned()) {
      scope.end();
      scope = null;
    }
    if (scope == null) {
      TagScope around = outer == null ? job.scopeForNew() : outer.scope(job);
      scope = TagScope.branch(job.scheduler(), new TagState(), around);
    }
    return scope;
  }
}

package org.urbi.kernel.library.concurrent;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A job as urbiscript sees it (manual, "Job"). */
final class UrbiJob extends UrbiObject {
  private final @Nullable Job job;

  UrbiJob(Shape shape, @Nullable Job job) {
    super(shape);
    this.job = job;
  }

  /** The job; null in the prototype. */
  @Nullable Job job() {
    return job;
  }
}

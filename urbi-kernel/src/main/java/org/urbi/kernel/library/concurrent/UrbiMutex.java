package org.urbi.kernel.library.concurrent;

import java.util.ArrayDeque;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.tag.UrbiTag;

/** A tag under which one job runs at a time; it may enter again (manual, "Mutex"). */
final class UrbiMutex extends UrbiTag {
  private final ArrayDeque<Job> queue = new ArrayDeque<>();
  private @Nullable Job owner;
  private int depth;

  UrbiMutex(Shape shape) {
    super(shape);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiMutex(cloneShape());
  }

  @Override
  protected void entering(Frame frame) {
    // Whoever enters keeps the others out.
    PermissionCheck.checkChange(frame, "lock", this);
    Job job = frame.job();
    if (owner != job) {
      if (owner == null && queue.isEmpty()) {
        owner = job;
      } else {
        await(job);
      }
    }
    depth++;
  }

  private void await(Job job) {
    queue.add(job);
    try {
      while (owner != job) {
        job.waitForWake(Wait.LOCK);
      }
    } catch (RuntimeException stopped) {
      queue.remove(job);
      if (owner == job) {
        next();
      }
      throw stopped;
    }
  }

  @Override
  protected void left(Frame frame) {
    if (depth > 0 && --depth == 0) {
      next();
    }
  }

  /** Gives the mutex to the job that has waited longest. */
  private void next() {
    owner = queue.poll();
    if (owner != null) {
      owner.wake();
    }
  }
}

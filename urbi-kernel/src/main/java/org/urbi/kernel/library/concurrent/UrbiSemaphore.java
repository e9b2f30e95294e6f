package org.urbi.kernel.library.concurrent;

import java.util.LinkedHashSet;
import java.util.Set;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** A limit for the number of jobs that use something (manual, "Semaphore"). */
final class UrbiSemaphore extends UrbiObject {
  private final Set<WaitingJob> queue = new LinkedHashSet<>();
  private int free;

  /** A job that waits for its turn. */
  private static final class WaitingJob {
    private final Job job;
    private boolean granted;

    WaitingJob(Job job) {
      this.job = job;
    }
  }

  UrbiSemaphore(Shape shape, int free) {
    super(shape);
    this.free = free;
  }

  void setFree(int places) {
    free = places;
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiSemaphore(cloneShape(), free);
  }

  /** Waits for a free place, and takes it; first come, first served. */
  void acquire(Job job) {
    if (free > 0) {
      free--;
      return;
    }
    WaitingJob ticket = new WaitingJob(job);
    queue.add(ticket);
    boolean entered = false;
    try {
      while (!ticket.granted) {
        job.waitForWake(Wait.LOCK);
      }
      entered = true;
    } finally {
      queue.remove(ticket);
      if (!entered && ticket.granted) {
        // The job was stopped after it was given the place: pass the place on.
        release();
      }
    }
  }

  /** Gives a place back. */
  void release() {
    if (queue.isEmpty()) {
      free++;
      return;
    }
    WaitingJob next = queue.iterator().next();
    queue.remove(next);
    next.granted = true;
    next.job.wake();
  }
}

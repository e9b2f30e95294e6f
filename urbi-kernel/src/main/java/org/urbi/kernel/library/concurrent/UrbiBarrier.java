package org.urbi.kernel.library.concurrent;

import java.util.ArrayDeque;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;

/** The jobs that wait at a barrier, oldest first (manual, "Barrier"). */
final class UrbiBarrier extends UrbiObject {
  private final ArrayDeque<Waiting> queue = new ArrayDeque<>();

  /** A job that waits. */
  private static final class Waiting {
    private final Job job;
    private @Nullable UrbiObject received;

    Waiting(Job job) {
      this.job = job;
    }
  }

  UrbiBarrier(Shape shape) {
    super(shape);
  }

  @Override
  public UrbiObject cloned() {
    return new UrbiBarrier(cloneShape());
  }

  /** Waits for a signal, and returns what came with it. */
  UrbiObject await(Job job) {
    Waiting waiting = new Waiting(job);
    queue.add(waiting);
    try {
      while (waiting.received == null) {
        job.waitForWake(Wait.SIGNAL);
      }
      return waiting.received;
    } finally {
      queue.remove(waiting);
    }
  }

  /** Wakes one job; false when none waits. */
  boolean signal(UrbiObject payload) {
    Waiting first = queue.poll();
    if (first == null) {
      return false;
    }
    first.received = payload;
    first.job.wake();
    return true;
  }
}

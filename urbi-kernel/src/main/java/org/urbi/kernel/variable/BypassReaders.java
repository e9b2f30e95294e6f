package org.urbi.kernel.variable;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.job.Timers;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.object.UrbiObject;

/**
 * The jobs that wait for the next value of a variable in bypass mode, which stores none (manual,
 * "0-copy mode").
 */
final class BypassReaders {
  /** How long they wait, in nanoseconds. */
  private static final long TIMEOUT = 500_000_000;

  private static final class Reader {
    private final Job job;
    private @Nullable UrbiObject value;
    private boolean late;

    Reader(Job job) {
      this.job = job;
    }
  }

  private final List<Reader> readers = new ArrayList<>(0);

  /** The next value; null if none is written in half a second. */
  @Nullable UrbiObject await(Job job) {
    Reader reader = new Reader(job);
    readers.add(reader);
    Scheduler scheduler = job.scheduler();
    Timers.Timer limit =
        scheduler
            .timers()
            .add(
                scheduler.deadline(TIMEOUT),
                () -> {
                  reader.late = true;
                  job.wake();
                });
    try {
      while (reader.value == null && !reader.late) {
        job.waitForWake(Wait.COMPONENT);
      }
      return reader.value;
    } finally {
      limit.cancel();
      readers.remove(reader);
    }
  }

  /** A value has been written. */
  void deliver(UrbiObject value) {
    for (Reader reader : readers) {
      reader.value = value;
      reader.job.wake();
    }
  }
}
